// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "kinematics/penetration.hpp"
#include "paper/arm_swivel.hpp"
#include "paper/reduced_motion.hpp"
#include "plan/plan.hpp"

namespace shigusa {

// The layers of a hierarchy, and the problem of the whole body: the common data of its motions.
struct LayeredProblem {
  ReachProblem reach;         // refers to the whole body
  bool in_reach = true;       // for the whole body; if false, paths end at the closest point
  std::vector<Layer> layers;  // the layers that lead to the goals (layers_to_goals)
  BodyLimbs limbs;
  std::vector<int> arms;              // (goals) index in limbs.arms
  std::vector<PosedBody> arm_bodies;  // (goals)
  // approaches of all joints of the whole body at once, to the goals or to the closest point
  std::vector<ReachProblem> body_approaches{};
};

// Whether a goal moves the arm.
[[nodiscard]] bool has_goal(const LayeredProblem& problem, const BodyLimb& arm);

// Path of one arm's hand in an upper motion, relative to its shoulder.
template <class S>
using HandPathOf =
    std::vector<Vec3<S>>;  // (frames) m, in the frame of the link that carries the arm
using HandPath = HandPathOf<double>;

// Target orientation of a goal's hand at the end of an upper motion, in its path's last frame.
template <class S>
[[nodiscard]] HandTurn<S> hand_turn(const LayeredProblem& problem, const ReducedClip<S>& clip,
                                    std::size_t goal) {
  const EffectorTurn& turn = problem.reach.goals[goal].turn;
  const Mat3<S>& carrier = clip.carriers[goal].back().rotation;
  return {turn.kind, transpose(carrier) * to_scalar<S>(turn.goal), to_scalar<S>(turn.axis),
          transpose_times(carrier, to_scalar<S>(turn.direction))};
}

// Every how many frames the search of the upper layer scores swivels.
inline constexpr int kCoarseFrames = 2;

// The data shared by all motions of a layered problem. The problem outlives it.
struct LayeredSetup {
  // Method that moves a goal's arm, and its index among the parameters of that method.
  struct GoalArm {
    bool by_swivel = false;
    std::size_t slot = 0;
  };
  // A dof with a final angle of its own.
  struct Final {
    std::size_t dof = 0;
    double start = 0.0;  // rad
  };

  // The dofs of one layer with final angles of their own, and the settings for their torques in its
  // criteria (the scale of torque).
  struct IdleLoads {
    double weight = 0.0;
    double share = 1.0;
    std::vector<int> dofs;
  };
  // The pairs of capsules of an idle arm.
  struct IdleArm {
    std::vector<CapsulePair> pairs;
  };

  explicit LayeredSetup(const LayeredProblem& problem);
  LayeredSetup(const LayeredSetup&) = delete;
  LayeredSetup& operator=(const LayeredSetup&) = delete;
  ~LayeredSetup();  // defined in the source file, shared by all SIMD sets

  [[nodiscard]] const BodyModel& body() const { return *problem->reach.body; }
  [[nodiscard]] const BodyLimb& arm(std::size_t goal) const {
    return problem->limbs.arms[index(problem->arms[goal])];
  }

  const LayeredProblem* problem;
  ReducedProblem upper;
  // (goals) of the arm: duration and number of steps; and in steps of kCoarseFrames frames
  std::vector<ReachProblem> alone;
  std::vector<ReachProblem> alone_coarsely;
  std::vector<GoalArm> arms;            // (goals)
  std::vector<std::vector<int>> moved;  // (goals) the body's dofs for those of the arm
  std::vector<Final> finals;            // in the layers' order
  std::vector<TrunkJoint> joints;       // those that carry an arm with a goal
  std::vector<IdleLoads> idle_loads;    // of layers with final angles
  std::vector<IdleArm> idle_arms;
  Kinematics<double> start;  // of the body

 private:
  void find_idle();
};

}  // namespace shigusa
