// SPDX-License-Identifier: MIT
// Deliberate defects of motions, to test the judges.
#include <algorithm>
#include <cmath>

#include "judged.hpp"

namespace shigusa::bench {
namespace {

constexpr Vec3d kOff{0.0, 0.002, 0.0};  // m

Mat3d turned_by(double angle) { return rotation(Axis::x, angle); }

Transformd& node_at(OutsideMotion& motion, const std::string& node, std::size_t frame) {
  return motion.places[frame][motion.nodes.at(node)];
}

std::size_t half_way(const OutsideMotion& motion) { return motion.frames() / 2; }

void spoil_goal(OutsideMotion& motion, const Candidate& candidate, bool turn) {
  for (const GoalResult& goal : candidate.goals) {
    if (!motion.has(goal.node)) continue;
    Transformd& end = node_at(motion, goal.node, motion.frames() - 1);
    if (turn) {
      end.rotation = turned_by(radians(0.7)) * end.rotation;
    } else {
      end.translation += kOff;
    }
  }
}

void spoil_foot(OutsideMotion& motion, const Candidate& candidate, bool turn) {
  for (const ContactResult& foot : candidate.contacts) {
    Transformd& place = node_at(motion, foot.node, half_way(motion));
    if (turn) {
      place.rotation = turned_by(radians(0.2)) * place.rotation;
    } else {
      place.translation += kOff;
    }
  }
}

void pass_a_limit(Judged& judged) {
  std::string name;
  double to = 0.0;
  if (judged.robot == nullptr) {
    name = judged.task.body.dof(0).name;
    to = judged.task.body.dof(0).lower;
  } else {
    for (const RobotTree::Joint& joint : judged.robot->joints()) {
      if (!joint.lower || !judged.table.has(joint.name + " [rad]")) continue;
      name = joint.name;
      to = *joint.lower;
      break;
    }
  }
  judged.table.column(name + " [rad]")[1] = to - radians(0.2);
}

void put_box_about_elbow(Judged& judged) {
  const BodyModel& body = judged.task.body;
  std::string elbow = "right_lower_arm";
  if (judged.robot != nullptr) {
    const auto effector = body.find_effector("right_elbow");
    if (!effector) return;
    elbow = body.effector(*effector).node;
  }
  if (!judged.motion.has(elbow)) return;
  const Vec3d at = judged.motion.at(elbow, half_way(judged.motion)).translation;
  if (norm(at - judged.motion.at(elbow, 0).translation) < 0.12) return;
  judged.task.obstacles.push_back({.name = "added", .position = at, .size = {0.08, 0.08, 0.08}});
}

void put_arm_in_head(Judged& judged) {
  if (!judged.motion.has("right_hand") || !judged.motion.has("head.end")) return;
  const std::size_t f = half_way(judged.motion);
  node_at(judged.motion, "right_hand", f).translation =
      (judged.motion.at("head", f).translation + judged.motion.at("head.end", f).translation) * 0.5;
}

void slide_rests(Judged& judged) {
  for (const RestResult& rest : judged.candidate.resting) {
    node_at(judged.motion, rest.node, judged.motion.frames() - 2).translation += kOff;
  }
}

void lower_boxes(Judged& judged) {
  for (Obstacle& obstacle : judged.task.obstacles) obstacle.radius -= kOff.y;
}

void halve_torques(Judged& judged) {
  for (const Dof& dof : judged.task.body.dofs()) {
    const std::string name = dof.name + " torque [N m]";
    if (!judged.table.has(name)) continue;
    for (double& torque : judged.table.column(name)) torque *= 0.5;
  }
  if (!judged.task.robot) return;
  for (const RobotJoint& joint : judged.task.robot->joints) {
    const std::string name = joint.name + " torque [N m]";
    if (!judged.table.has(name)) continue;
    for (double& torque : judged.table.column(name)) torque *= 0.5;
  }
}

void hide_reasons(ReasonKind kind, Judged& judged) {
  Judgement& judgement = judged.candidate.judgement;
  const auto is_so = [kind](const Reason& reason) { return reason.kind == kind; };
  if (std::none_of(judgement.reasons.begin(), judgement.reasons.end(), is_so)) return;
  judgement = {};
}

}  // namespace

void spoil(Flaw flaw, Judged& judged) {
  switch (flaw) {
    case Flaw::none:
    case Flaw::order_wrong:
      return;
    case Flaw::goal_off:
    case Flaw::goal_turned:
      return spoil_goal(judged.motion, judged.candidate, flaw == Flaw::goal_turned);
    case Flaw::other_file_off:
      for (OutsideMotion& other : judged.other_files) spoil_goal(other, judged.candidate, false);
      return;
    case Flaw::foot_slid:
    case Flaw::foot_tilted:
      return spoil_foot(judged.motion, judged.candidate, flaw == Flaw::foot_tilted);
    case Flaw::limit_passed:
      return pass_a_limit(judged);
    case Flaw::box_in_limb:
      return put_box_about_elbow(judged);
    case Flaw::arm_in_head:
      return put_arm_in_head(judged);
    case Flaw::seat_low:
      for (auto& frame : judged.motion.places) {
        for (Transformd& node : frame) node.translation = node.translation - kOff;
      }
      return;
    case Flaw::heel_told_high:
      for (ContactResult& foot : judged.candidate.contacts) {
        if (foot.heel) foot.heel->height += kOff.y;
      }
      return;
    case Flaw::rest_slid:
      return slide_rests(judged);
    case Flaw::rest_off:
      return lower_boxes(judged);
    case Flaw::torque_told_low:
      return halve_torques(judged);
    case Flaw::weakness_hidden:
      return hide_reasons(ReasonKind::strength, judged);
    case Flaw::tipping_hidden:
      return hide_reasons(ReasonKind::pressure, judged);
  }
}

}  // namespace shigusa::bench
