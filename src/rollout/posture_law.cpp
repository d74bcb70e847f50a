// SPDX-License-Identifier: MIT
#include "rollout/posture_law.hpp"

#include <shigusa/human.hpp>

#include "body/posture_modes.hpp"
#include "kinematics/weighted_ik.hpp"

namespace shigusa {
namespace {

// Side (+1 left, -1 right) of the only hand with a goal; 0 for none or both.
double side_of_hand(const ReachProblem& problem) {
  double side = 0.0;
  for (const ReachGoal& goal : problem.goals) {
    const JointPlace& part = problem.body->effector(goal.effector).part;
    if (part.joint_kind != JointKind::hand || !part.side) continue;
    side += part.side == Side::left ? 1.0 : -1.0;
  }
  return side;
}

// Share in which legs follow a pelvis that turns for a goal at this azimuth (rad). With given
// rotations, or both hands, ankles would reach their limits, and the motion would jolt.
double legs_follow(const ReachProblem& problem, double azimuth) {
  if (problem.asked() != 1 || problem.goals[0].turn.kind != Turning::free) return 0.0;
  return clamp((azimuth - kLegsFollow) / (kLegsAll - kLegsFollow), 0.0, 1.0);
}

// The change (dofs, rad) of the start posture nearest to the given one that keeps the feet in
// place: legs follow a turning pelvis, whatever their weights.
std::vector<double> on_planted_feet(const ReachProblem& problem, const Kinematics<double>& standing,
                                    std::span<const double> change) {
  constexpr double kPart = 0.01;  // share of the change made in one IK step
  std::vector<Constraint<double>> planted = constraints(problem);
  std::erase_if(planted, [](const auto& each) { return !each.exact || !each.holds_at(0.0); });
  const std::vector<double> weights(change.size(), 1.0);
  std::vector<double> part(change.begin(), change.end());
  for (double& angle : part) angle *= kPart;
  IkWorkspace<double> workspace(*problem.body);
  const auto step = weighted_ik_step<double>(*problem.body, standing, {planted, weights, part},
                                             problem.ik, workspace);
  for (std::size_t d = 0; d < part.size(); ++d) part[d] = step[d] / kPart;
  return part;
}

}  // namespace

double back_bend(const BodyModel& body, const CriteriaContext& context) {
  const double load = min(heaviest_load(context.start), kBackLoadMost);
  return kBackBend * body.lumbar_part() * (1.0 + kBackOfLoad * load) + context.habit.round;
}

double back_share(std::size_t joint, std::size_t joints) {
  return spine_shares(joint, joints).flexion;
}

Mat3d rotation_at_start(const ReachProblem& problem, int link) {
  return placed(*problem.body, problem.start()).link_rotation(link);
}

ArmAtStart arm_at_start(const ReachProblem& problem, const ArmLinks& links, double side) {
  const Kinematics<double> standing = placed(*problem.body, problem.start());
  const Hanging<double> hangs = hanging(standing.link_rotation(links.parent), side);
  const Shrug<double> rises = shrugged(transpose_times(standing.link_rotation(links.chest),
                                                       -standing.link_rotation(links.upper).cy));
  return {hangs.flexion, hangs.abduction, rises.elevation, rises.protraction};
}

double head_share(const ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  const auto left = body.find_dof(JointKind::shoulder, FreedomKind::flexion, Side::left);
  const auto right = body.find_dof(JointKind::shoulder, FreedomKind::flexion, Side::right);
  if (!left || !right) return 1.0;
  const Kinematics<double> start = placed(body, problem.start());
  const Vec3d across = start.link_origin(*left) - start.link_origin(*right);
  const Vec3d side = normalized(across);
  double least = 1e9;
  double most = -1e9;
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.name != body_part_name(BodyPart::head)) continue;
    for (const Vec3d& end : {capsule.from, capsule.to}) {
      const double at = dot(start.point(capsule.link, end), side);
      least = min(least, at - thickest(capsule));
      most = max(most, at + thickest(capsule));
    }
  }
  const double broader = (most - least) / max(norm(across), 1e-3);
  const double squared = broader * broader;
  return broader > 1.0 ? 1.0 / (squared * squared) : 1.0;
}

std::vector<CapsulePair> clearance_pairs(const ReachProblem& problem, const Effector& hand) {
  const BodyModel& body = *problem.body;
  const Kinematics<double> start = placed(body, problem.start());
  std::vector<CapsulePair> pairs = limb_pairs(body, hand);
  std::erase_if(pairs, [&](const CapsulePair& pair) {
    const std::string& part = body.capsules()[index(pair.part)].name;
    const auto is = [&](BodyPart which) { return part == body_part_name(which); };
    return is(BodyPart::neck) || is(BodyPart::head) || is(BodyPart::jaw);
  });
  for (CapsulePair& pair : pairs) pair.allowed = deepest_of(body, start, {&pair, 1}).depth;
  return pairs;
}

double scapula_share(const ReachProblem& problem, const ArmLinks& links) {
  const BodyModel& body = *problem.body;
  const Kinematics<double> standing = placed(body, problem.start());
  const Vec3d shoulder = standing.origin[index(links.upper)];
  const auto height = [&](const Vec3d& point) {
    return dot(normalized(point - shoulder), standing.link_rotation(links.chest).cy);
  };
  for (const ReachGoal& goal : problem.goals) {
    const Effector& hand = body.effector(goal.effector);
    if (!body.moves(links.upper, hand.link)) continue;
    const Vec3d from = standing.point(hand.link, hand.point);
    return height(goal.path.at(1.0)) < height(from) ? kScapulaLowers : 1.0;
  }
  return 1.0;
}

TrunkTurn trunk_turn(const ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  const auto neck = body.find_dof(JointKind::neck, FreedomKind::flexion);
  if (!problem.context.gaze || !neck) return {};
  const Kinematics<double> standing = placed(body, problem.start());
  const Vec3d eye = standing.origin[index(*neck)];
  const Vec3d way =
      transpose_times(standing.link_rotation(body.dof(*neck).parent), *problem.context.gaze - eye);
  const double across = way.x * way.x + way.z * way.z;
  double azimuth = atan2(way.x, way.z);
  const double side = side_of_hand(problem);
  if (side * azimuth < 0.0 && abs(azimuth) > kBehind) azimuth += side * kTwoPi;
  const double beyond = max(abs(azimuth) - kTrunkTurns, 0.0);
  // beyond 45 degrees above or below, the azimuth counts less and less
  const double level = min(sqrt(2.0 * across / max(across + way.y * way.y, 1e-6)), 1.0);
  const double turn = min(beyond * kTrunkOfGaze, kTrunkMost) * level;
  if (!(turn > 0.0)) return {};
  for (PostureMode& mode : posture_modes(body)) {
    if (mode.name != "twist") continue;
    const double to = azimuth > 0.0 ? 1.0 : -1.0;
    for (double& share : mode.direction) share *= to * turn;
    const double legs = legs_follow(problem, abs(azimuth));
    if (legs > 0.0) {
      const std::vector<double> planted = on_planted_feet(problem, standing, mode.direction);
      for (std::size_t d = 0; d < planted.size(); ++d) {
        mode.direction[d] += legs * (planted[d] - mode.direction[d]);
      }
    }
    return {to, std::move(mode.direction)};
  }
  return {};
}

}  // namespace shigusa
