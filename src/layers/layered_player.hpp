// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "layers/arm_swivel.hpp"
#include "layers/clip_dynamics.hpp"
#include "layers/plan.hpp"
#include "layers/reduced_motion.hpp"
#include "rollout/rollout.hpp"

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

// Where the upper layer leads one arm: the path of its hand as its shoulder sees it.
using HandPath = std::vector<Vec3d>;  // (frames) m, in the frame of the link that carries the arm

// The turn that a goal wants of its hand at the end of an upper motion, in its path's last frame.
[[nodiscard]] EffectorTurn hand_turn(const LayeredProblem& problem, const ReducedClip& clip,
                                     std::size_t goal);

// Plays a hierarchy from the top: the reduced body moves, then its rods become limbs again. Legs
// follow in closed form from where the pelvis is (paper, section 3.4; rule R3), their feet where
// they stand; arms that have a goal move along the path that the rod's end took, by weights or by
// their swivel; what has a final angle goes to it with minimum jerk; head, free arm and its
// clavicle follow PostureLaw, where the problem has it; the rest stays as it is. Holds its scratch
// memory: make one per thread. The problem outlives it.
class LayeredPlayer {
 public:
  explicit LayeredPlayer(const LayeredProblem& problem);

  // The upper layer's motion.
  void run_upper(const Parameters& parameters, ReducedClip& clip) { upper_.run(parameters, clip); }
  // The hand's path of each goal in an upper motion.
  [[nodiscard]] std::vector<HandPath> hand_paths(const ReducedClip& clip) const;
  // How far the legs' joints would pass their limits for the pelvis of an upper motion (rad, the
  // most of any frame; rule R4), and whether all legs can be so long.
  struct PelvisCheck {
    double excess = 0.0;
    bool in_reach = true;
  };
  [[nodiscard]] PelvisCheck check_pelvis(const ReducedClip& clip) const;
  // The whole body's motion for an upper motion and the parameters of the layers below; those of
  // the upper layer are the clip's. A hand whose arm cannot follow its path with its weights
  // (locked, mostly) leaves it.
  [[nodiscard]] RolledOut expand(const ReducedClip& clip, const Parameters& parameters);
  // Expands so, but gives an arm that cannot follow its path the weights of all freedoms alike.
  [[nodiscard]] RolledOut expand_freeing(const ReducedClip& clip, Parameters& parameters);

 private:
  using ArmAngles = std::vector<std::vector<double>>;  // [goal] (frames × dofs of the arm) rad
  struct LegLine {
    double lean = 0.0;    // rad, in the leg's plane
    double length = 0.0;  // m
    double turn = 0.0;    // rad, about the foot's z: of the leg's plane, where the ankle inverts
  };
  // Moves a goal's arm by one of two methods, with its place among the parameters.
  struct GoalArm {
    std::unique_ptr<ArmRollout> by_weights{};
    std::unique_ptr<SwivelArm> by_swivel{};
    std::size_t slot = 0;
  };
  struct Final {
    std::size_t dof = 0;
    double start = 0.0;  // rad
  };

  void add_finals(const Layer& layer);
  [[nodiscard]] LegLine leg_line(const BodyLimb& leg, const ReducedClip& clip, int frame) const;
  void bend_leg(const BodyLimb& leg, const LegLine& line, const Mat3d& trunk,
                std::span<double> angles) const;
  [[nodiscard]] double inversion(const BodyLimb& leg, const LegLine& line) const;
  void follow_law(int frame, std::span<double> angles);
  void check_counts(const Parameters& parameters) const;
  double move_arm(std::size_t goal, const ReducedClip& clip, const HandPath& path,
                  const Parameters& parameters, std::vector<double>& angles);
  [[nodiscard]] RolledOut expanded(const ReducedClip& clip, const ArmAngles& arm_angles,
                                   std::span<const double> finals);
  [[nodiscard]] Clip expanded_clip(const ReducedClip& clip, const ArmAngles& arm_angles,
                                   std::span<const double> finals);
  [[nodiscard]] ReachOutcome measured(Motion& motion);

  const LayeredProblem* problem_;
  const BodyModel* body_;
  ReducedRollout upper_;
  Kinematics<double> start_;
  Kinematics<double> placed_;
  ClipDynamics whole_;
  std::vector<GoalArm> arms_;       // (goals)
  std::vector<Final> finals_;       // in the layers' order
  std::vector<TrunkJoint> joints_;  // those that carry an arm with a goal
  PostureLaw<double> law_;
  std::vector<double> drawn_;        // (dofs) rad, by the law
  std::vector<PelvisRange> ranges_;  // (legs)
};

}  // namespace shigusa
