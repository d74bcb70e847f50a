// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "body/posture_modes.hpp"
#include "core/index.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// The progress of a change of posture in each frame, with separate timing for each part of the
// body.
template <class S>
class PostureDraw {
 public:
  // The problem outlives the object.
  explicit PostureDraw(const ReachProblem& problem)
      : problem_(&problem),
        parts_(timed_parts(*problem.body)),
        rise_(problem.rise.begin(), problem.rise.end()),
        legs_(leg_flexions(*problem.body)) {}

  // Sets the reference (dofs, rad) to the increment of the change `posture` (dofs, rad) in the step
  // to this frame. The change begins after the share `delay` of each part's time. A locked knee
  // (inverse weight 0) leaves hips and ankles alone.
  void draw(int frame, std::span<const S> posture, std::span<const S> inverse_weights,
            const S& delay, std::span<S> reference) const {
    std::array<S, kTimedParts> shares;
    for (std::size_t p = 0; p < kTimedParts; ++p) {
      const auto part = static_cast<TimedPart>(p);
      shares[p] = made(part, frame, delay) - made(part, frame - 1, delay);
    }
    for (std::size_t d = 0; d < reference.size(); ++d) {
      reference[d] = changed(d, posture) * shares[parts_[d]];
    }
    // hips and ankles follow the knees' timing in proportion to the knee's bend, so that a squat
    // stays in balance; the rest follows the lean's timing
    const S& squats = shares[static_cast<std::size_t>(TimedPart::knees)];
    const S& leans = shares[static_cast<std::size_t>(TimedPart::hips)];
    for (const LegFlexions& leg : legs_) {
      const S knee = select(inverse_weights[leg.knee] > S(0), changed(leg.knee, posture), S(0));
      const S part = knee * S(kOfKnee);
      for (const std::size_t d : {leg.hip, leg.ankle}) {
        reference[d] = part * squats + (changed(d, posture) - part) * leans;
      }
    }
  }

  // The change of a dof (rad), with that of a rise.
  [[nodiscard]] S changed(std::size_t d, std::span<const S> posture) const {
    return rise_.empty() ? posture[d] : posture[d] + S(rise_[d]);
  }

  // Share of its change completed by a part at a frame.
  [[nodiscard]] S made(TimedPart part, int frame, const S& delay) const {
    const TimeWindow& window = problem_->windows[static_cast<std::size_t>(part)];
    const S tau(window.at(problem_->tau(frame)));
    return minimum_jerk((tau - delay) / (S(1) - delay));
  }

 private:
  const ReachProblem* problem_;
  std::vector<std::size_t> parts_;  // (dofs) the TimedPart of each
  std::vector<double> rise_;        // (dofs) rad, or empty: see ReachProblem::rise
  std::vector<LegFlexions> legs_;
};

}  // namespace shigusa
