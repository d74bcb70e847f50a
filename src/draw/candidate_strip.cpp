// SPDX-License-Identifier: MIT
#include "candidate_strip.hpp"

#include <optional>
#include <string_view>

#include "body/joint_name.hpp"
#include "body/seat.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "problem/thing_parts.hpp"
#include "work_strip.hpp"

namespace shigusa {
namespace {

// The limb that a goal moves, from the effector's name; empty for trunk and head.
std::optional<Limb> limb_of(std::string_view effector) {
  const JointPlace part = parse_joint_name(effector);
  if (!part.side) return std::nullopt;
  const bool left = part.side == Side::left;
  if (part.limb == LimbKind::leg) return left ? Limb::left_leg : Limb::right_leg;
  return left ? Limb::left_arm : Limb::right_arm;
}

std::vector<Vec3d> box_corners(const Vec3d& low, const Vec3d& high) {
  std::vector<Vec3d> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back({(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                       (k & 4) != 0 ? high.z : low.z});
  }
  return corners;
}

std::vector<Vec3d> corners_of(const Obstacle& box) {
  const Mat3d turn = to_matrix(box.rotation);
  std::vector<Vec3d> corners = box_corners(box.size * -0.5, box.size * 0.5);
  for (Vec3d& corner : corners) corner = box.position + turn * corner;
  return corners;
}

// Corners of the seat block under a seated person's thighs, down to the floor; empty if standing.
// Sole corners are part of a thigh's contact outline and are left out.
std::vector<Vec3d> seat_corners(const PosedBody& posed) {
  constexpr double kAboveSoles = 0.08;  // m; seats are higher than that
  const Kinematics<double> start = home_kinematics(posed);
  Vec3d low{};
  Vec3d high{};
  bool any = false;
  for (const Foot& foot : posed.body.feet()) {
    if (!is_on_seat(foot)) continue;
    for (const Vec3d& corner : foot.outline) {
      const Vec3d at = start.point(foot.link, corner);
      if (at.y < kAboveSoles) continue;
      if (!any) low = high = at;
      any = true;
      for (int k = 0; k < 3; ++k) {
        low[k] = min(low[k], at[k]);
        high[k] = max(high[k], at[k]);
      }
    }
  }
  if (!any) return {};
  // a sloping thigh rests on its lower end
  return box_corners({low.x, 0.0, low.z}, {high.x, low.y, high.z});
}

}  // namespace

std::vector<StripThing> things_around(const Task& task) {
  std::vector<StripThing> things;
  for (const Obstacle& box : task.obstacles) things.push_back({corners_of(box), box.radius});
  if (std::vector<Vec3d> seat = seat_corners(task); !seat.empty()) {
    things.push_back({std::move(seat)});
  }
  return things;
}

StripSettings strip_settings(const Task& task, const Candidate& candidate) {
  StripSettings settings;
  settings.floor = 0.0;
  settings.facing = Vec3d{0, 0, 1};
  settings.accented.clear();
  const auto accent = [&settings](const Goal& goal) {
    if (const auto limb = limb_of(goal.effector)) settings.accented.push_back(*limb);
  };
  for (const Goal& goal : task.goals) accent(goal);
  for (const ActionResult& action : candidate.actions) {
    // who stands up brings all limbs home
    if (action.kind == ActionKind::stand || action.kind == ActionKind::sit) continue;
    for (const GoalResult& goal : action.goals) accent(goal.asked);
  }
  return settings;
}

MotionStrip candidate_strip(const Task& task, const Candidate& candidate) {
  MotionStrip strip{
      skeleton_motion(task.body, candidate.motion.clip), {}, strip_settings(task, candidate)};
  strip.settings.frames = work_frames(candidate);
  strip.overlay.actions = work_actions(candidate);
  for (const GoalResult& goal : candidate.goals) {
    if (candidate.actions.empty()) strip.overlay.goals.push_back(goal.asked.position);
  }
  strip.overlay.things = things_around(task);
  for (const ThingMotion& way : candidate.things) {
    for (const Thing& part : split(way.thing)) {
      ThingMotion own{part, way.poses};
      for (Transformd& pose : own.poses) pose.translation = pose * part.position;
      strip.overlay.things.push_back(moving_thing(own));
    }
  }
  strip.overlay.centre_of_mass = candidate.motion.centre_of_mass;
  if (!candidate.motion.effectors.empty()) {
    strip.overlay.hand_path = candidate.motion.effectors.front();
  }
  return strip;
}

}  // namespace shigusa
