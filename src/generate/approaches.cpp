// SPDX-License-Identifier: MIT
#include "approaches.hpp"

#include <algorithm>
#include <limits>
#include <shigusa/generate.hpp>
#include <utility>

#include "distinct.hpp"
#include "motion/jolt.hpp"
#include "nlp/nlp_rollout.hpp"
#include "problem/tiptoe.hpp"
#include "rollout/detour.hpp"

namespace shigusa {
namespace {

// Extra IK steps per frame where the goal is out of reach: stretched limbs turn fast and would jolt
// into the last frame.
constexpr int kEdgeCorrections = 3;

// Distance (m) that a hand at the edge of reach may still move in the last frame.
constexpr double kRestStep = 1e-3;

bool ends_at_rest(const Motion& motion) {
  for (const std::vector<Vec3d>& path : motion.effectors) {
    if (path.size() > 1 && norm(path.back() - path[path.size() - 2]) > kRestStep) return false;
  }
  return true;
}

// Whether a motion fulfils its approach; beyond reach it must also end at rest and without a jolt.
bool arrives(const ReachProblem& approach, const RolledOut& rolled) {
  if (!rolled.outcome.met(approach.tolerance)) return false;
  if (approach.tolerance.goal <= kReachTolerance) return true;
  return !jolts(rolled.motion.clip) && ends_at_rest(rolled.motion);
}

bool carries(const ReachProblem& problem) {
  return std::any_of(problem.goals.begin(), problem.goals.end(),
                     [](const ReachGoal& goal) { return goal.carry.has_value(); });
}

}  // namespace

std::vector<ReachProblem> approaches_to_goal(ReachProblem problem, const ClosestReach& reach,
                                             bool straight) {
  // a path to a box ends at the effector's position in the posture known to arrive
  for (std::size_t g = 0; reach.reached() && g < problem.goals.size(); ++g) {
    problem.goals[g].end_nearest(reach.positions[g]);
  }
  if (reach.reached() && !straight) add_detours(problem);
  ReachProblem guided = problem;
  guided.guide = reach.angles;
  ReachProblem posture = guided;
  posture.follow_path = false;
  // weights alone can lift the heels without regard to balance
  const bool tiptoe = reach.reached() && Tiptoe(problem, reach.angles).lifted();
  if (tiptoe) return {guided, posture};
  // hands on a thing keep to its way
  if (reach.reached() && carries(problem)) return {problem, guided};
  if (reach.reached()) return {problem, guided, posture};
  // Edge of reach: the path ends at the closest point, and a hand on a stretched limb may lag
  // behind its path.
  guided.tolerance = posture.tolerance = {kEdgeTolerance, std::numeric_limits<double>::infinity()};
  guided.corrections = posture.corrections = kEdgeCorrections;
  for (std::size_t g = 0; g < problem.goals.size(); ++g) {
    guided.goals[g].path.goal = posture.goals[g].path.goal = reach.positions[g];
    const EffectorTurn turn = problem.goals[g].turn.ending_at(reach.turns[g]);
    guided.goals[g].turn = posture.goals[g].turn = turn;
  }
  return {guided, posture};
}

RolledOut play(const ReachProblem& problem, const Parameters& parameters,
               MotionGenerator generator) {
  return generator == MotionGenerator::nlp_ik ? roll_out_nlp(problem, parameters)
                                              : roll_out(problem, parameters);
}

std::optional<Arrival> first_arrival(std::span<const ReachProblem> approaches,
                                     const Parameters& parameters, MotionGenerator generator) {
  for (const ReachProblem& approach : approaches) {
    RolledOut rolled = play(approach, parameters, generator);
    if (arrives(approach, rolled)) return Arrival{&approach, std::move(rolled)};
  }
  return std::nullopt;
}

Arrival nearest_arrival(std::span<const ReachProblem> approaches, const Parameters& parameters,
                        MotionGenerator generator) {
  if (auto arrival = first_arrival(approaches, parameters, generator)) return std::move(*arrival);
  std::optional<Arrival> best;
  for (const ReachProblem& approach : approaches) {
    RolledOut rolled = play(approach, parameters, generator);
    const bool stands = rolled.outcome.stands();
    const bool best_stands = best && best->rolled.outcome.stands();
    const bool nearer = best && rolled.outcome.goal_error < best->rolled.outcome.goal_error;
    if (!best || (stands == best_stands ? nearer : stands))
      best = Arrival{&approach, std::move(rolled)};
  }
  return std::move(*best);
}

}  // namespace shigusa
