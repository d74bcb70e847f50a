// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>

namespace shigusa {

// Bones of a limb from the trunk outwards.
using LimbBones = std::array<HumanoidBone, 3>;

// Left leg, right leg, left arm, right arm.
inline constexpr std::array<LimbBones, 4> kLimbBones{{
    {HumanoidBone::left_upper_leg, HumanoidBone::left_lower_leg, HumanoidBone::left_foot},
    {HumanoidBone::right_upper_leg, HumanoidBone::right_lower_leg, HumanoidBone::right_foot},
    {HumanoidBone::left_upper_arm, HumanoidBone::left_lower_arm, HumanoidBone::left_hand},
    {HumanoidBone::right_upper_arm, HumanoidBone::right_lower_arm, HumanoidBone::right_hand},
}};
[[nodiscard]] constexpr const LimbBones& leg_bones(Side side) {
  return kLimbBones[side == Side::left ? 0 : 1];
}
[[nodiscard]] constexpr const LimbBones& arm_bones(Side side) {
  return kLimbBones[side == Side::left ? 2 : 3];
}

// All bones in their order.
inline constexpr std::array<HumanoidBone, kHumanoidBoneCount> kHumanoidBones = [] {
  std::array<HumanoidBone, kHumanoidBoneCount> bones{};
  for (std::size_t i = 0; i < bones.size(); ++i) bones[i] = static_cast<HumanoidBone>(i);
  return bones;
}();

inline constexpr std::array kBothSides{Side::left, Side::right};

[[nodiscard]] inline Vec3d mid_hip(const Landmarks& p) {
  return (p.left_leg.hip + p.right_leg.hip) * 0.5;
}
[[nodiscard]] inline Vec3d mid_shoulder(const Landmarks& p) {
  return (p.left_arm.shoulder + p.right_arm.shoulder) * 0.5;
}

// Lengths of thigh, shank, upper arm and forearm.
[[nodiscard]] inline std::array<double, 4> segment_lengths(const Landmarks& p, Side side) {
  const Landmarks::Leg& leg = p.leg(side);
  const Landmarks::Arm& arm = p.arm(side);
  return {norm(leg.hip - leg.knee), norm(leg.knee - leg.ankle), norm(arm.shoulder - arm.elbow),
          norm(arm.elbow - arm.wrist)};
}

// Visits landmarks by name, in their order in files.
template <class Person, class Visit>
void for_each_landmark(Person& p, Visit&& visit) {
  visit("left_hip", p.left_leg.hip);
  visit("left_knee", p.left_leg.knee);
  visit("left_ankle", p.left_leg.ankle);
  visit("left_toe", p.left_leg.toe);
  visit("right_hip", p.right_leg.hip);
  visit("right_knee", p.right_leg.knee);
  visit("right_ankle", p.right_leg.ankle);
  visit("right_toe", p.right_leg.toe);
  visit("left_shoulder", p.left_arm.shoulder);
  visit("left_elbow", p.left_arm.elbow);
  visit("left_wrist", p.left_arm.wrist);
  visit("left_fingertip", p.left_arm.fingertip);
  visit("right_shoulder", p.right_arm.shoulder);
  visit("right_elbow", p.right_arm.elbow);
  visit("right_wrist", p.right_arm.wrist);
  visit("right_fingertip", p.right_arm.fingertip);
  visit("neck", p.neck);
  visit("head_top", p.head_top);
}

// Visits the points that a person may lack.
template <class Person, class Visit>
void for_each_further_landmark(Person& p, Visit&& visit) {
  visit("head", p.head);
  visit("left_clavicle", p.left_arm.clavicle);
  visit("right_clavicle", p.right_arm.clavicle);
  visit("left_toes", p.left_leg.toes);
  visit("right_toes", p.right_leg.toes);
  visit("left_grip", p.left_arm.grip);
  visit("right_grip", p.right_arm.grip);
}

// Visits every point of a person except shapes of parts, which are relative to their parts.
template <class Person, class Visit>
void for_each_point(Person& p, Visit&& visit) {
  for_each_landmark(p, [&](const char*, auto& point) { visit(point); });
  for_each_further_landmark(p, [&](const char*, auto& point) {
    if (point) visit(*point);
  });
  for (auto& joint : p.spine) visit(joint);
  for (auto* leg : {&p.left_leg, &p.right_leg}) {
    if (!leg->sole) continue;
    for (auto& corner : *leg->sole) visit(corner);
  }
}

}  // namespace shigusa
