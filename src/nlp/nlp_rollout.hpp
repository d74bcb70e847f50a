// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "nlp/nlp_ik.hpp"
#include "rollout/posture_draw.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// Generates a motion from parameters by nonlinear programming (see NlpIk) instead of weighted IK:
// the same problems, inputs, frames and outcomes as Rollout<double>, so that both can be scored
// alike.
//
//   for each frame:
//     targets := points of the paths in this frame
//     reference := the null space's change of posture in this frame, or towards the guide
//     posture := NlpIk's, after the posture of the frame before
//
// It ignores the settings of a ReachProblem for weighted IK, which compensate for linear steps:
// damping, leads, corrections and their slacks. NlpIkSettings replaces them. Limits are always
// kept, whatever problem.hold_limits says: they belong to the program.
class NlpRollout {
 public:
  // The problem and its body outlive the object.
  explicit NlpRollout(const ReachProblem& problem, const NlpIkSettings& settings = {});

  // Rolls out one motion. visit(const PlacedFrame<double>&) is called for the frames 0..steps in
  // order.
  template <class Visitor>
  ReachOutcome run(const MotionInput<double>& input, Visitor&& visit) {
    ReachOutcome outcome;
    begin(input);
    for (int frame = 1; frame <= problem_->steps; ++frame) {
      follow(frame, input, outcome);
      visit(dynamics_.frame(angles_, now_));
      advance();
    }
    // the motion ends at rest
    angles_[2] = angles_[1];
    visit(dynamics_.frame(angles_, now_));
    return outcome;
  }

  // (dofs, rad) the last frame of the last motion.
  [[nodiscard]] std::span<const double> final_angles() const { return angles_[1]; }

 private:
  void begin(const MotionInput<double>& input);
  void follow(int frame, const MotionInput<double>& input, ReachOutcome& outcome);
  void advance();
  void place_goals(int frame, const MotionInput<double>& input);
  void draw_null_space(int frame, const MotionInput<double>& input);
  void measure(std::span<Constraint<double>> targets, bool last, ReachOutcome& outcome);

  const ReachProblem* problem_;
  std::size_t contacts_from_;                // index of the first contact among the targets
  std::vector<Constraint<double>> targets_;  // the goals, then the contacts
  NlpIk ik_;
  LimitGuard<double> limits_;
  FrameDynamics<double> dynamics_;
  Kinematics<double> now_;                   // placement in this frame
  Kinematics<double> next_;                  // placement in the next frame
  std::vector<std::vector<double>> angles_;  // of the frame before, this one and the next
  bool drawn_ = false;                       // whether the null space has a reference
  std::vector<double> reference_;            // (dofs, rad) of this frame
  PostureDraw<double> posture_draw_;
};

// Generates and records the whole motion of the parameters.
[[nodiscard]] RolledOut roll_out_nlp(const ReachProblem& problem, const Parameters& parameters);

}  // namespace shigusa
