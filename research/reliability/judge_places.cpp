// SPDX-License-Identifier: MIT
// Judges of positions: goals, feet, limits, boxes, flesh, seats, resting hands.
#include <algorithm>
#include <cmath>

#include "boxes.hpp"
#include "judged.hpp"
#include "support/flesh.hpp"

namespace shigusa::bench {
namespace {

// Height of the hip joints over a seat, as a share of the stature (kSeatedHip).
constexpr double kHipOverSeat = 0.05;
// Share of a motion after which every resting hand has arrived.
constexpr double kArrived = 0.9;

double angle_between(const Vec3d& a, const Vec3d& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// Rotation of a goal's effector at the end, from its rotation since the start.
Mat3d turned_at_end(const Judged& judged, const OutsideMotion& motion, std::size_t g) {
  const GoalResult& told = judged.candidate.goals[g];
  const Mat3d since =
      motion.at_end(told.node).rotation * transpose(motion.at(told.node, 0).rotation);
  return since * to_matrix(told.turn.start);
}

void judge_goal(const Judged& judged, const OutsideMotion& motion, std::size_t g, Audit& audit) {
  const Goal& asked = judged.task.goals[g];
  const std::string& node = judged.candidate.goals[g].node;
  audit.require(motion.has(node), "the file has no node " + node);
  if (!motion.has(node)) return;
  const Vec3d off = motion.at_end(node).translation - asked.position;
  audit.most(Promise::goal, norm(off), asked.effector);
  if (asked.rotation) {
    const Mat3d left = turned_at_end(judged, motion, g) * transpose(to_matrix(*asked.rotation));
    audit.most(Promise::turn, norm(rotation_vector(left)), asked.effector);
  }
  if (asked.axis) {
    const Vec3d axis = turned_at_end(judged, motion, g) * normalized(asked.axis->axis);
    audit.most(Promise::turn, angle_between(axis, normalized(asked.axis->direction)),
               asked.effector);
  }
}

// Whether a joint of the table is missing from the robot's file, as an added ankle is.
bool moves_made_joints(const Judged& judged) {
  if (judged.robot == nullptr) return false;
  const auto& joints = judged.robot->joints();
  const auto& of_body = judged.task.robot->joints;
  return std::any_of(of_body.begin(), of_body.end(), [&](const RobotJoint& joint) {
    return std::none_of(joints.begin(), joints.end(),
                        [&](const RobotTree::Joint& known) { return known.name == joint.name; });
  });
}

void judge_feet_of(const Judged& judged, const OutsideMotion& motion, Audit& audit) {
  for (const ContactResult& foot : judged.candidate.contacts) {
    if (!motion.has(foot.node)) continue;
    audit.most(Promise::slide, motion.slide(foot.node), foot.node);
    // a thigh's twist may be shared with other bones of its file
    const std::string knee = knee_of(foot.node);
    if (!knee.empty() && motion.has(knee)) {
      audit.most(Promise::tilt, motion.tilt(foot.node, knee), foot.node);
    } else if (!foot.heel) {
      audit.most(Promise::tilt, motion.tilt(foot.node), foot.node);
    }
  }
}

void judge_robots_limits(const Judged& judged, Audit& audit) {
  for (const RobotTree::Joint& joint : judged.robot->joints()) {
    const std::string name = joint.name + " [rad]";
    if (!joint.lower || !judged.table.has(name)) continue;
    for (const double angle : judged.table.column(name)) {
      audit.most(Promise::limit, std::fmax(*joint.lower - angle, angle - *joint.upper), joint.name);
    }
  }
}

const Obstacle* obstacle_of(const Task& task, const std::string& name) {
  for (const Obstacle& obstacle : task.obstacles) {
    if (obstacle.name == name) return &obstacle;
  }
  return nullptr;
}

// m: half the thickness of a flat hand
double half_hand(const BodyModel& body, const std::string& effector) {
  const int link = body.effector(body.find_effector(effector).value()).link;
  double half = 0.0;
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.link != link) continue;
    half = std::fmax(half, std::fmin(capsule.radius, capsule.to_radius));
  }
  return half;
}

// a position in the frame of its carrier
Vec3d place_on(const Judged& judged, const RestResult& rest, std::size_t frame) {
  const Vec3d at = judged.motion.at(rest.node, frame).translation;
  if (rest.on != kThighPlace) return at;
  const bool left = rest.effector.starts_with("left");
  const Transformd& thigh = judged.motion.at(left ? "left_upper_leg" : "right_upper_leg", frame);
  return transpose_times(thigh.rotation, at - thigh.translation);
}

}  // namespace

void judge_goals(const Judged& judged, Audit& audit) {
  if (!judged.meets_goals) return;
  for (std::size_t g = 0; g < judged.task.goals.size(); ++g) {
    judge_goal(judged, judged.motion, g, audit);
    for (const OutsideMotion& other : judged.other_files) {
      if (other.has(judged.candidate.goals[g].node)) judge_goal(judged, other, g, audit);
    }
  }
}

void judge_feet(const Judged& judged, Audit& audit) {
  if (moves_made_joints(judged)) return;
  judge_feet_of(judged, judged.motion, audit);
  for (const OutsideMotion& other : judged.other_files) judge_feet_of(judged, other, audit);
}

void judge_limits(const Judged& judged, Audit& audit) {
  // closed forms of layers, and the paper's own steps of IK, may exceed limits, and report it
  if (!judged.candidate.measures.over_limit.empty()) {
    ++audit.over_limit;
    audit.require(judged.task.preset != Preset::flat,
                  "a limit is passed by the preset flat, which holds limits");
    return;
  }
  if (judged.robot != nullptr) return judge_robots_limits(judged, audit);
  const BodyModel& body = judged.task.body;
  for (int d = 0; d < body.dof_count(); ++d) {
    double upper = body.dof(d).upper;
    for (const LimitCoupling& coupling : body.couplings()) {
      if (coupling.dof == d) upper += coupling.gain;
    }
    for (const double angle : judged.table.column(body.dof(d).name + " [rad]")) {
      audit.most(Promise::limit, std::fmax(body.dof(d).lower - angle, angle - upper),
                 body.dof(d).name);
    }
  }
}

bool told_as_free(const Judged& judged) {
  const auto& reasons = judged.candidate.judgement.reasons;
  return judged.candidate.measures.collides.depth <= kCollisionDepth &&
         std::none_of(reasons.begin(), reasons.end(),
                      [](const Reason& reason) { return reason.kind == ReasonKind::collision; });
}

void judge_boxes(const Judged& judged, Audit& audit) {
  if (judged.task.obstacles.empty() || !told_as_free(judged)) return;
  const BoneInBox found = deepest_bone(judged.task, judged.candidate, judged.motion);
  audit.most(Promise::box, found.depth, found.bone.from + " to " + found.bone.to);
  if (judged.candidate.resting.empty()) return;
  ++audit.resting;
  const BoneInBox hand = deepest_bone(judged.task, judged.candidate, judged.motion, true);
  if (hand.depth > kBoneInBox) ++audit.rest_through;
}

void judge_flesh(const Judged& judged, Audit& audit) {
  if (!is_built_in(judged.character) || !told_as_free(judged)) return;
  const auto depths = testing_support::Flesh(judged.motion, judged.task.body.stature()).deepest();
  ++audit.fleshed;
  audit.head = std::fmax(audit.head, depths.head);
  audit.shank = std::fmax(audit.shank, depths.shank);
  if (std::fmax(depths.head, depths.shank) > kThroughFlesh) ++audit.through;
}

void judge_seat(const Judged& judged, Audit& audit) {
  if (!judged.character.seat) return;
  const double height = *judged.character.seat + kHipOverSeat * judged.task.body.stature();
  for (std::size_t f = 0; f < judged.motion.frames(); ++f) {
    const double hips = 0.5 * (judged.motion.at("left_upper_leg", f).translation.y +
                               judged.motion.at("right_upper_leg", f).translation.y);
    audit.most(Promise::seat, std::fabs(hips - height));
  }
  for (const std::string foot : {"left_foot", "right_foot"}) {
    audit.most(Promise::slide, judged.motion.slide(foot), foot);
  }
}

void judge_rests(const Judged& judged, Audit& audit) {
  const std::size_t end = judged.motion.frames() - 1;
  for (const RestResult& rest : judged.candidate.resting) {
    const Vec3d last = place_on(judged, rest, end);
    const auto arrived = static_cast<std::size_t>(std::ceil(kArrived * static_cast<double>(end)));
    for (std::size_t f = arrived; f < end; ++f) {
      audit.most(Promise::rest, norm(place_on(judged, rest, f) - last), rest.effector);
    }
    const Obstacle* box = obstacle_of(judged.task, rest.on);
    if (box == nullptr) continue;
    const double over = distance_from(*box, judged.motion.at_end(rest.node).translation);
    audit.most(Promise::on_box, std::fabs(over - half_hand(judged.task.body, rest.effector)),
               rest.effector);
  }
}

}  // namespace shigusa::bench
