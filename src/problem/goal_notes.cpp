// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <shigusa/human.hpp>
#include <shigusa/request.hpp>
#include <string_view>

#include "body/capsules.hpp"
#include "core/say.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "task_supports.hpp"

namespace shigusa {
namespace {

// Depth (m) from which a point counts as inside a part, not at its skin.
constexpr double kInside = 0.01;

// Parts that may contain a goal by oversight: they protrude from the body, and large heads get in
// the way.
constexpr std::array kParts{BodyPart::head, BodyPart::jaw, BodyPart::left_foot,
                            BodyPart::right_foot};

// The part that contains a point; "" if there is none.
std::string part_at(const BodyModel& body, const Kinematics<double>& start, const Vec3d& place) {
  const Capsule point{.name = {}, .from = place, .to = place, .radius = 0.0};
  for (Capsule capsule : body.capsules()) {
    const auto is = [&](BodyPart part) { return capsule.name == body_part_name(part); };
    if (std::none_of(kParts.begin(), kParts.end(), is)) continue;
    capsule.from = start.point(capsule.link, capsule.from);
    capsule.to = start.point(capsule.link, capsule.to);
    if (capsule_depth(point, capsule) <= kInside) continue;
    return std::string(is(BodyPart::jaw) ? body_part_name(BodyPart::head) : capsule.name);
  }
  return {};
}

}  // namespace

std::vector<Message> goal_notes(const Task& task) {
  const BodyModel& body = task.body;
  const Kinematics<double> start = placed(body, task.start);
  std::vector<Message> notes;
  for (const Goal& goal : task.goals) {
    const auto index = body.find_effector(goal.effector);
    if (!index || body.effector(*index).part.limb != LimbKind::arm) continue;
    const double height = goal.position.y;
    const double half = half_thickness(body, body.effector(*index));
    if (height < 0.0) {
      notes.push_back(say("goal_below_floor", goal.effector, Metres{-height}));
    } else if (height < half) {
      notes.push_back(
          say("goal_in_floor", goal.effector, Metres{height}, Millimetres{std::round(1e3 * half)}));
    }
    const std::string part = part_at(body, start, goal.position);
    if (!part.empty()) notes.push_back(say("goal_in_part", goal.effector, part));
  }
  return notes;
}

}  // namespace shigusa
