// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <vector>

namespace shigusa {

// A node that takes a share of a limb's twist, such as "LeftForeArmTwist".
struct TwistBone {
  int node = -1;
  // bone of its segment: an upper or a lower leg or arm
  HumanoidBone bone = HumanoidBone::left_lower_arm;
  double share = 0.0;  // 0..1 of the length from the segment's joint to the next
  bool chain = false;  // whether the next joint is its descendant
};

// Twist bones of a skeleton in the posture `world` (nodes, as from world_transforms), with their
// positions along the limb: joint and next joint are 0 and 1.
//
// - A node between a limb's bone and the next one is a twist bone if it is on the line between the
//   two and well apart from both, whatever its name (Rigify's DEF-forearm.L.001, Daz's
//   lForearmTwist).
// - Any other node is a twist bone by its name (twist, roll, 捩; ulna) if it is near that line:
//   below the limb's bone (Unreal's lowerarm_twist_01_l), or below the parent of that bone without
//   having a bone below it.
//
// Forearm twist bones that are all at the elbow share the twist by their number.
[[nodiscard]] std::vector<TwistBone> find_twist_bones(const Skeleton& skeleton,
                                                      const std::vector<Transformd>& world,
                                                      const HumanoidMap& map);

// Whether the limb's bone itself has no twist, because twist bones take it up: a lower limb with
// any of them, an upper one with some between it and the next bone.
[[nodiscard]] bool untwisted(const std::vector<TwistBone>& twists, HumanoidBone bone);

// The four kinds of segments that twist, with the bone at their end: upper arm, forearm, thigh,
// shank.
struct TwistSegment {
  HumanoidBone bone;
  HumanoidBone next;
  bool lower;  // takes the twist of the joint at its end; an upper one of that at its beginning
};
[[nodiscard]] const std::array<TwistSegment, 8>& twist_segments();

}  // namespace shigusa
