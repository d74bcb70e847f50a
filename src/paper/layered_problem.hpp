// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "kinematics/penetration.hpp"
#include "paper/arm_swivel.hpp"
#include "paper/reduced_motion.hpp"
#include "plan/plan.hpp"

namespace shigusa {

// The layers of a hierarchy, and the problem of the whole body: all that its motions depend on.
struct LayeredProblem {
  ReachProblem reach;         // points to the whole body
  bool in_reach = true;       // of the whole body; if not, paths end at the closest point
  std::vector<Layer> layers;  // those to the goals (layers_to_goals)
  BodyLimbs limbs;
  std::vector<int> arms;              // (goals) index in limbs.arms
  std::vector<BodyModel> arm_bodies;  // (goals)
  // how all joints of the whole body at once go to the goals, or to the closest point
  std::vector<ReachProblem> body_approaches{};
};

// Whether a goal moves the arm.
[[nodiscard]] bool has_goal(const LayeredProblem& problem, const BodyLimb& arm);

// Where the upper layer leads one arm: the path of its hand as its shoulder sees it.
template <class S>
using HandPathOf =
    std::vector<Vec3<S>>;  // (frames) m, in the frame of the link that carries the arm
using HandPath = HandPathOf<double>;

// The turn that a goal wants of its hand at the end of an upper motion, in its path's last frame.
template <class S>
[[nodiscard]] HandTurn<S> hand_turn(const LayeredProblem& problem, const ReducedClip<S>& clip,
                                    std::size_t goal) {
  const EffectorTurn& turn = problem.reach.goals[goal].turn;
  const Mat3<S>& carrier = clip.carriers[goal].back().rotation;
  return {turn.kind, transpose(carrier) * to_scalar<S>(turn.goal), to_scalar<S>(turn.axis),
          transpose_times(carrier, to_scalar<S>(turn.direction))};
}

// The search of the upper layer scores swivels by one frame of this number.
inline constexpr int kCoarseFrames = 2;

// All that the motions of a layered problem have in common. The problem outlives it.
struct LayeredSetup {
  // One of the two methods that move a goal's arm, with its place among the parameters.
  struct GoalArm {
    bool by_swivel = false;
    std::size_t slot = 0;
  };
  // A freedom that ends at an angle of its own.
  struct Final {
    std::size_t dof = 0;
    double start = 0.0;  // rad
  };

  // The freedoms of one layer that end at angles of their own, and how its criteria see their
  // torques (TorqueSettings).
  struct IdleLoads {
    double weight = 0.0;
    double share = 1.0;
    std::vector<int> dofs;
  };
  // The pairs of capsules of an arm that no goal moves.
  struct IdleArm {
    std::vector<CapsulePair> pairs;
  };

  explicit LayeredSetup(const LayeredProblem& problem);
  LayeredSetup(const LayeredSetup&) = delete;
  LayeredSetup& operator=(const LayeredSetup&) = delete;
  ~LayeredSetup();  // in the source file, where all SIMD sets share it

  [[nodiscard]] const BodyModel& body() const { return *problem->reach.body; }
  [[nodiscard]] const BodyLimb& arm(std::size_t goal) const {
    return problem->limbs.arms[index(problem->arms[goal])];
  }

  const LayeredProblem* problem;
  ReducedProblem upper;
  // (goals) of the arm: how long it moves, in how many steps; and in steps of kCoarseFrames frames
  std::vector<ReachProblem> alone;
  std::vector<ReachProblem> alone_coarsely;
  std::vector<GoalArm> arms;            // (goals)
  std::vector<std::vector<int>> moved;  // (goals) the body's dofs that the arm's are
  std::vector<Final> finals;            // in the layers' order
  std::vector<TrunkJoint> joints;       // those that carry an arm with a goal
  std::vector<IdleLoads> idle_loads;    // of layers that have final angles
  std::vector<IdleArm> idle_arms;
  Kinematics<double> start;  // of the body

 private:
  void find_idle();
};

}  // namespace shigusa
