// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/files.hpp>
#include <shigusa/request.hpp>
#include <string>

#include "glb_export.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// Motions of a body on its character's own skeleton. Borrows the rig.
class CharacterExporter final : public GlbExporter {
 public:
  explicit CharacterExporter(const CharacterRig& character, const HandPlay& hands = {},
                             const FileSettings& settings = {})
      : character_(character), hands_(hands), settings_(settings) {}

  // With the nodes of the file; of a BVH also with its channels and in its unit, else in
  // centimetres.
  [[nodiscard]] std::string bvh(const BodyModel& body, const Clip& clip) const;

  // Rotations of the nodes that turn, the hips' translation, and the nodes that the start frame has
  // elsewhere than the rest pose.
  [[nodiscard]] GltfAnimation animation(const BodyModel& body, const Clip& clip,
                                        const std::string& name) const override;

  // The character's glTF file with animations added before its own, or in their place.
  [[nodiscard]] Result<std::string> glb(std::span<const GltfAnimation> animations) const override;

  // A VRM animation: the character's bones of VRM but for eyes and jaw, which stay, and fingers
  // where they do.
  [[nodiscard]] Result<std::string> vrma(const BodyModel& body, const Clip& clip,
                                         const std::string& name) const;

 private:
  [[nodiscard]] RigMotion motion_of(const BodyModel& body, const Clip& clip, const Rig& rig) const;

  const CharacterRig& character_;
  HandPlay hands_;
  FileSettings settings_;
};

// The play of hands that a task asks for: those that have goals open and close.
[[nodiscard]] HandPlay hand_play(const Task& task);

// The bone of VRM 1.0 that a node is in a VRM animation; empty where it is none.
[[nodiscard]] std::string vrma_bone(const CharacterRig& character, int node, bool fingers);

// m per unit of the BVH that a character leaves in.
[[nodiscard]] double bvh_unit(const CharacterSpec& spec);

}  // namespace shigusa
