// SPDX-License-Identifier: MIT
#include <shigusa/strip_figure.hpp>

#include "body/joint_name.hpp"
#include "export_file.hpp"
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

Result<MadeFile> motion_strip(const WriteRequest& request, FigureFormat format) {
  const auto& [character, task, candidate, settings] = request;
  StripOverlay overlay;
  for (const GoalResult& goal : candidate.goals) overlay.goals.push_back(goal.asked.position);
  overlay.centre_of_mass = candidate.motion.centre_of_mass;
  overlay.hand_path = candidate.motion.effectors.front();
  return unread(draw_strip(skeleton_motion(task.body, candidate.motion.clip), overlay,
                           strip_settings(task), format));
}

}  // namespace

template <>
Result<MadeFile> write_as<FileFormat::svg>(const WriteRequest& request) {
  return motion_strip(request, FigureFormat::svg);
}

template <>
Result<MadeFile> write_as<FileFormat::png>(const WriteRequest& request) {
  return motion_strip(request, FigureFormat::png);
}

template <>
Result<MadeFile> write_as<FileFormat::pdf>(const WriteRequest& request) {
  return motion_strip(request, FigureFormat::pdf);
}

}  // namespace shigusa
