// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/files.hpp>

#include "draw/mannequin.hpp"
#include "glb_export.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// Motions of a built-in body as the mannequin's. Nodes of the file are the body's, by the names
// that are asked for, then those beside them, and last the one that shows the mesh.
class MannequinExporter final : public GlbExporter {
 public:
  MannequinExporter(const CharacterSpec& character, const BodyModel& body, const HandPlay& hands,
                    const FileSettings& settings);

  // Rotations of the nodes that turn and the hips' translation.
  [[nodiscard]] GltfAnimation animation(const BodyModel& body, const Clip& clip,
                                        const std::string& name) const override;
  [[nodiscard]] Result<std::string> glb(std::span<const GltfAnimation> animations) const override;

 private:
  std::string name_;  // the body's
  Skeleton named_;    // the mannequin's, by the names in the file
  Mannequin mannequin_;
  std::vector<Vec3d> skin_;  // m, where the mesh is made
  HandPlay hands_;
  FileSettings settings_;
};

}  // namespace shigusa
