// SPDX-License-Identifier: MIT
#include "rollout/rollout.hpp"

#include "record_motion.hpp"

namespace shigusa {

namespace {

// Distance (m) of a moving hand from the straight line to its place, half-way.
constexpr double kSupportLift = 0.04;
// Share of the duration in which a hand builds up its force after arrival.
constexpr double kPressRises = 0.15;

}  // namespace

double HandSupport::lift(double tau) const { return kSupportLift * path_bow(done(tau), 0.0); }

double HandSupport::bears(double tau) const { return minimum_snap((tau - arrives) / kPressRises); }

Mat3d CarriedWay::turned(double share) const { return rotation_by(turn * share) * from; }

Vec3d ReachGoal::place_at(double tau) const {
  if (!carry) return path.at(tau);
  const double done = path.done(tau);
  return carry->start + (carry->goal - carry->start) * done + carry->turned(done) * carry->grip +
         path.detour * minimum_jerk_detour(path.own_time(tau), path.detour_peak);
}

Mat3d ReachGoal::turn_at(double tau) const {
  if (carry) return carry->turned(path.done(tau)) * carry->hand;
  const Mat3d turned = turn.at(path.own_time(tau));
  return spin == Vec3d{} ? turned : rotation_by(spin * carried_on(tau)) * turned;
}

State ReachProblem::standing() const {
  State state{.angles = start().angles};
  for (std::size_t d = 0; d < rise.size(); ++d) state.angles[d] += rise[d];
  if (rise.empty()) return state;
  // the law of the back straightens it with the pelvis
  for (const JointKind joint : kBackJoints) {
    for (const int d : body->dofs_of(joint, FreedomKind::flexion)) state.angles[index(d)] = 0.0;
  }
  return state;
}

std::vector<double> ReachProblem::momentum() const {
  std::vector<double> momentum = start().velocities;
  for (double& angle : momentum) angle *= duration;
  return momentum;
}

Vec3d ReachGoal::nearest(const Vec3d& at, double inset) const {
  Vec3d place{};
  for (int k = 0; k < 3; ++k) {
    const double half = max(tolerance[k] - inset, 0.0);
    place[k] = clamp(at[k], path.goal[k] - half, path.goal[k] + half);
  }
  return place;
}

namespace {

TimedPart timed_part(const Dof& dof) {
  const JointKind joint = dof.part.joint_kind;
  if (joint == JointKind::knee) return TimedPart::knees;
  if (joint == JointKind::hip || joint == JointKind::ankle) return TimedPart::hips;
  const bool back = std::find(kBackJoints.begin(), kBackJoints.end(), joint) != kBackJoints.end();
  return back ? TimedPart::spine : TimedPart::arms;
}

}  // namespace

std::vector<std::size_t> timed_parts(const BodyModel& body) {
  std::vector<std::size_t> parts;
  for (const Dof& dof : body.dofs()) parts.push_back(static_cast<std::size_t>(timed_part(dof)));
  return parts;
}

std::vector<LegFlexions> leg_flexions(const BodyModel& body) {
  std::vector<LegFlexions> legs;
  for (const Side side : {Side::right, Side::left}) {
    const auto knee = body.find_dof(JointKind::knee, FreedomKind::flexion, side);
    const auto hip = body.find_dof(JointKind::hip, FreedomKind::flexion, side);
    const auto ankle = body.find_dof(JointKind::ankle, FreedomKind::flexion, side);
    if (knee && hip && ankle) legs.push_back({index(*knee), index(*hip), index(*ankle)});
  }
  return legs;
}

std::vector<Constraint<double>> constraints(const ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  const Kinematics<double> kinematics = placed(body, problem.start());
  std::vector<Constraint<double>> all;
  for (const ReachGoal& goal : problem.goals) {
    const Effector& effector = body.effector(goal.effector);
    all.push_back({.link = effector.link,
                   .point = effector.point,
                   .place = goal.path.goal,
                   .counts = all.size() < problem.asked(),
                   .turning = goal.turn.kind,
                   .orientation = goal.turn.goal,
                   .axis = goal.turn.axis,
                   .direction = goal.turn.direction,
                   .turn_counts = goal.carry ? 1.0 : kTurnOnWay});
  }
  for (const Foot& foot : body.feet()) {
    if (foot.link == kBaseLink) continue;
    all.push_back({.link = foot.link,
                   .point = foot.centre,
                   .place = kinematics.point(foot.link, foot.centre),
                   .exact = true,
                   .turning = Turning::whole,
                   .orientation = kinematics.link_rotation(foot.link)});
  }
  for (const HandSupport& support : problem.supports) {
    const Effector& hand = body.effector(support.effector);
    all.push_back({.link = hand.link,
                   .point = hand.point,
                   .carrier = support.carrier,
                   .place = support.place,
                   .exact = true,
                   .from = support.arrives});
  }
  return all;
}

RolledOut roll_out(const ReachProblem& problem, const Parameters& parameters) {
  return record_motion(problem, parameters, Rollout<double>(problem));
}

}  // namespace shigusa
