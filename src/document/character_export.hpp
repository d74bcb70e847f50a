// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/files.hpp>
#include <shigusa/request.hpp>
#include <string>

#include "glb_export.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// Writer of a body's motions on the character's own skeleton. Borrows the rig.
class CharacterExporter final : public GlbExporter {
 public:
  explicit CharacterExporter(const CharacterRig& character, const FileSettings& settings = {})
      : character_(character), settings_(settings) {}

  // BVH text with the nodes of the character's file. A character from a BVH file keeps its channels
  // and unit; others are in centimetres.
  [[nodiscard]] std::string bvh(const PosedBody& body, const Clip& clip,
                                const HandPlay& hands = {}) const;

  // Animation tracks: rotations of the nodes that turn, the translation of the hips, and the nodes
  // whose start frame differs from the rest pose.
  [[nodiscard]] GltfAnimation animation(const PosedBody& body, const Clip& clip,
                                        const std::string& name,
                                        const MotionExtras& extras) const override;

  // The character's glTF file with the animations added before its own, or replacing them.
  [[nodiscard]] Result<std::string> glb(std::span<const GltfAnimation> animations) const override;

  // VRM animation of the character's VRM bones. Eyes and jaw are left out, and so are fingers that
  // do not move. It holds no things.
  [[nodiscard]] Result<std::string> vrma(const PosedBody& body, const Clip& clip,
                                         const std::string& name, const MotionExtras& extras) const;

 private:
  [[nodiscard]] RigMotion motion_of(const PosedBody& body, const Clip& clip, const Rig& rig,
                                    const HandPlay& hands) const;

  const CharacterRig& character_;
  FileSettings settings_;
};

// VRM 1.0 bone of a node in a VRM animation; empty if it has none.
[[nodiscard]] std::string vrma_bone(const CharacterRig& character, int node, bool fingers);

// Unit (m) of the BVH file that a character is exported to.
[[nodiscard]] double bvh_unit(const CharacterSpec& spec);

}  // namespace shigusa
