// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>

#include "io/gltf_write.hpp"

namespace shigusa {

// Motions of a body on its character's own skeleton. Borrows the rig.
class CharacterExporter {
 public:
  explicit CharacterExporter(const CharacterRig& character) : character_(character) {}

  // With the nodes of the file; of a BVH also with its channels and in its unit, else in
  // centimetres.
  [[nodiscard]] std::string bvh(const BodyModel& body, const Clip& clip) const;

  // The animation that glb() adds: rotations of the nodes that turn, the hips' translation, and
  // the nodes that the start frame has elsewhere than the rest pose.
  [[nodiscard]] GltfAnimation animation(const BodyModel& body, const Clip& clip,
                                        const std::string& name) const;

  // The character's glTF file with animations added.
  [[nodiscard]] Result<std::string> glb(std::span<const GltfAnimation> animations) const;

  // A VRM animation: the character's bones of VRM but for fingers, eyes and jaw, which stay.
  [[nodiscard]] Result<std::string> vrma(const BodyModel& body, const Clip& clip,
                                         const std::string& name) const;

 private:
  const CharacterRig& character_;
};

// m per unit of the BVH that a character leaves in.
[[nodiscard]] double bvh_unit(const CharacterSpec& spec);

}  // namespace shigusa
