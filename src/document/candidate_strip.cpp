// SPDX-License-Identifier: MIT
#include "candidate_strip.hpp"

#include <optional>
#include <string_view>

#include "body/joint_name.hpp"
#include "kinematics/skeleton_motion.hpp"

namespace shigusa {
namespace {

// The limb that a goal moves, by the effector's name; none of the trunk and the head.
std::optional<Limb> limb_of(std::string_view effector) {
  const JointPlace part = parse_joint_name(effector);
  if (!part.side) return std::nullopt;
  const bool left = part.side == Side::left;
  if (part.limb == LimbKind::leg) return left ? Limb::left_leg : Limb::right_leg;
  return left ? Limb::left_arm : Limb::right_arm;
}

}  // namespace

StripSettings strip_settings(const Task& task) {
  StripSettings settings;
  settings.floor = 0.0;
  settings.facing = Vec3d{0, 0, 1};
  settings.accented.clear();
  for (const Goal& goal : task.goals) {
    if (const auto limb = limb_of(goal.effector)) settings.accented.push_back(*limb);
  }
  return settings;
}

MotionStrip candidate_strip(const Task& task, const Candidate& candidate) {
  MotionStrip strip{skeleton_motion(task.body, candidate.motion.clip), {}, strip_settings(task)};
  for (const GoalResult& goal : candidate.goals) {
    strip.overlay.goals.push_back(goal.asked.position);
  }
  strip.overlay.centre_of_mass = candidate.motion.centre_of_mass;
  strip.overlay.hand_path = candidate.motion.effectors.front();
  return strip;
}

}  // namespace shigusa
