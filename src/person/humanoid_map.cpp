// SPDX-License-Identifier: MIT
#include <array>
#include <shigusa/skeleton.hpp>

#include "bone_finder.hpp"
#include "person/find_humanoid.hpp"

namespace shigusa {

std::string_view humanoid_bone_name(HumanoidBone bone) {
  constexpr std::array<std::string_view, kHumanoidBoneCount> kNames{
      "hips",
      "neck",
      "head",
      "left_upper_leg",
      "left_lower_leg",
      "left_foot",
      "left_toes",
      "right_upper_leg",
      "right_lower_leg",
      "right_foot",
      "right_toes",
      "left_upper_arm",
      "left_lower_arm",
      "left_hand",
      "right_upper_arm",
      "right_lower_arm",
      "right_hand",
      "spine",
      "chest",
      "upper_chest",
      "left_shoulder",
      "right_shoulder",
  };
  return kNames[static_cast<std::size_t>(bone)];
}

Result<HumanoidMap> find_humanoid(const Skeleton& skeleton, const std::vector<Transformd>& world,
                                  const HumanoidMap& given, const HumanoidMap& asked,
                                  std::span<const SkinVertex> skin) {
  const SkeletonTree tree(skeleton, world, skin);
  return BoneFinder(tree, given, asked).find();
}

}  // namespace shigusa
