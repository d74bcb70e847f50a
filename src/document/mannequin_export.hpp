// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/files.hpp>

#include "draw/mannequin.hpp"
#include "glb_export.hpp"

namespace shigusa {

// Writer of a built-in body's motions on the mannequin. Nodes of the file are the body's, named by
// the requested convention, then the mannequin's additional ones, and last the mesh node.
class MannequinExporter final : public GlbExporter {
 public:
  MannequinExporter(const CharacterSpec& character, const BodyModel& body,
                    const FileSettings& settings);

  // Animation tracks: rotations of the nodes that turn and the translation of the hips.
  [[nodiscard]] GltfAnimation animation(const PosedBody& body, const Clip& clip,
                                        const std::string& name,
                                        const MotionExtras& extras) const override;
  [[nodiscard]] Result<std::string> glb(std::span<const GltfAnimation> animations) const override;

 private:
  std::string name_;  // name of the body
  Skeleton named_;    // the mannequin's skeleton, by the names in the file
  Mannequin mannequin_;
  std::vector<Vec3d> skin_;  // m, vertex positions of the mesh
  FileSettings settings_;
};

}  // namespace shigusa
