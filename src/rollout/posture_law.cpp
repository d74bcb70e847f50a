// SPDX-License-Identifier: MIT
#include "rollout/posture_law.hpp"

#include "body/posture_modes.hpp"

namespace shigusa {
namespace {

// The side (+1 left, -1 right) of the one hand that has a goal; 0 where it is not one.
double side_of_hand(const ReachProblem& problem) {
  double side = 0.0;
  for (const ReachGoal& goal : problem.goals) {
    const std::string& name = problem.body->effector(goal.effector).name;
    if (name == "left_hand") side += 1.0;
    if (name == "right_hand") side -= 1.0;
  }
  return side;
}

}  // namespace

ArmAtStart arm_at_start(const BodyModel& body, const ArmLinks& links, double side) {
  const Kinematics<double> standing = start_kinematics(body);
  const Hanging<double> hangs = hanging(standing.link_rotation(links.parent), side);
  const Shrug<double> rises = shrugged(transpose_times(standing.link_rotation(links.chest),
                                                       -standing.link_rotation(links.upper).cy));
  return {hangs.flexion, hangs.abduction, rises.elevation, rises.protraction};
}

double scapula_share(const ReachProblem& problem, const ArmLinks& links) {
  const BodyModel& body = *problem.body;
  const Kinematics<double> standing = start_kinematics(body);
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
  const auto neck = body.find_dof("neck.flexion");
  if (!problem.gaze || !neck) return {};
  const Kinematics<double> standing = start_kinematics(body);
  const Vec3d eye = standing.origin[index(*neck)];
  const Vec3d way =
      transpose_times(standing.link_rotation(body.dof(*neck).parent), *problem.gaze - eye);
  const double across = way.x * way.x + way.z * way.z;
  double azimuth = atan2(way.x, way.z);
  const double side = side_of_hand(problem);
  if (side * azimuth < 0.0 && abs(azimuth) > kBehind) azimuth += side * kTwoPi;
  const double beyond = max(abs(azimuth) - kTrunkTurns, 0.0);
  // what is more than 45 degrees above or below is less and less on any side
  const double level = min(sqrt(2.0 * across / max(across + way.y * way.y, 1e-6)), 1.0);
  const double turn = min(beyond * kTrunkOfGaze, kTrunkMost) * level;
  if (!(turn > 0.0)) return {};
  for (PostureMode& mode : posture_modes(body)) {
    if (mode.name != "twist") continue;
    const double to = azimuth > 0.0 ? 1.0 : -1.0;
    for (double& share : mode.direction) share *= to * turn;
    return {to, std::move(mode.direction)};
  }
  return {};
}

}  // namespace shigusa
