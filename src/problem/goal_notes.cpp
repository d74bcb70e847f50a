// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <shigusa/human.hpp>
#include <shigusa/request.hpp>
#include <utility>

#include "body/capsules.hpp"
#include "body/seat.hpp"
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

// Where people take a step: bearings (rad) from straight ahead of what is behind them, and of what
// is beside them below the knees, both farther from the hips than kStepAside; horizontal distances
// (statures) of what is far, above the knees and below. The cases are those in which motions on the
// spot looked unlike people; the numbers are chosen.
constexpr double kStepBehind = radians(110.0);
constexpr double kStepBeside = radians(60.0);
constexpr double kStepAside = 0.2;
constexpr double kStepFar = 0.58;
constexpr double kStepFarLow = 0.45;

// Why a standing person takes a step to a goal; none without a reason.
std::optional<Message> why_step(const BodyModel& body, const Kinematics<double>& start,
                                const Goal& goal) {
  const auto at = [&](HumanoidBone bone) -> std::optional<Vec3d> {
    const BodyNode* node = body.find_node(humanoid_bone_name(bone));
    if (node == nullptr) return std::nullopt;
    return start.point(node->link, node->point);
  };
  const auto left = at(HumanoidBone::left_upper_leg);
  const auto right = at(HumanoidBone::right_upper_leg);
  const auto knee = at(HumanoidBone::right_lower_leg);
  if (!left || !right || !knee || sits(body) || body.is_robot()) return std::nullopt;
  const Vec3d across = *left - *right;
  const Vec3d way = goal.position - 0.5 * (*left + *right);
  const double bearing =
      abs(atan2(way.x * across.x + way.z * across.z, way.z * across.x - way.x * across.z));
  const double distance = sqrt(way.x * way.x + way.z * way.z) / body.stature();
  const bool low = goal.position.y < knee->y;
  const bool aside = distance > kStepAside;
  if (aside && bearing > kStepBehind) return say("step_behind", goal.effector);
  if (aside && low && bearing > kStepBeside) return say("step_beside", goal.effector);
  if (distance <= (low ? kStepFarLow : kStepFar)) return std::nullopt;
  return say("step_far", goal.effector);
}

// Whether a box, by its upright extent, bears what stands at a place.
bool bears(const Vec3d& position, const Vec3d& size, double radius, const Vec3d& place,
           double bottom) {
  constexpr double kNear = 0.03;  // m
  const double top = position.y + 0.5 * size.y + radius;
  const double wide = 0.5 * max(size.x, size.z) + radius;
  return abs(top - bottom) < kNear && abs(place.x - position.x) < wide &&
         abs(place.z - position.z) < wide;
}

// The note that an action puts a thing on nothing: neither the floor nor an obstacle nor a thing.
std::optional<Message> why_in_air(const Task& task, const Action& action) {
  constexpr double kOnFloor = 0.03;  // m
  if (action.place.empty() || !action.position) return std::nullopt;
  const auto named = [&](const Thing& thing) { return thing.name == action.place; };
  const auto thing = std::find_if(task.things.begin(), task.things.end(), named);
  if (thing == task.things.end()) return std::nullopt;
  const double bottom = action.position->y - 0.5 * thing->size.y;
  bool borne = bottom < kOnFloor;
  for (const Obstacle& under : task.obstacles) {
    borne = borne || bears(under.position, under.size, under.radius, *action.position, bottom);
  }
  // another thing may stand there by then
  for (const Thing& under : task.things) {
    borne = borne || under.name != thing->name;
  }
  if (borne) return std::nullopt;
  return say("in_mid_air", thing->name);
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
    if (auto why = why_step(body, start, goal)) notes.push_back(std::move(*why));
  }
  for (const Action& action : task.actions) {
    if (auto note = why_in_air(task, action)) notes.push_back(std::move(*note));
  }
  return notes;
}

}  // namespace shigusa
