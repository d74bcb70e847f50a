// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "body/posture_modes.hpp"
#include "core/index.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// How far a change of posture is made in each frame, part by part in its own time.
template <class S>
class PostureDraw {
 public:
  // The problem outlives it.
  explicit PostureDraw(const ReachProblem& problem)
      : problem_(&problem),
        parts_(timed_parts(*problem.body)),
        legs_(leg_flexions(*problem.body)) {}

  // Sets the reference (dofs, rad) to what the step to this frame makes of the change `posture`
  // (dofs, rad), which begins after the share `delay` of each part's time.
  // A locked knee (of inverse weight 0) takes nothing of hips and ankles along.
  void draw(int frame, std::span<const S> posture, std::span<const S> inverse_weights,
            const S& delay, std::span<S> reference) const {
    std::array<S, kTimedParts> shares;
    for (std::size_t p = 0; p < kTimedParts; ++p) {
      const auto part = static_cast<TimedPart>(p);
      shares[p] = made(part, frame, delay) - made(part, frame - 1, delay);
    }
    for (std::size_t d = 0; d < reference.size(); ++d) {
      reference[d] = posture[d] * shares[parts_[d]];
    }
    // what bends with the knees keeps their time, so that a squat is in balance on its way; the
    // rest of hips and ankles keeps the lean's
    const S& squats = shares[static_cast<std::size_t>(TimedPart::knees)];
    const S& leans = shares[static_cast<std::size_t>(TimedPart::hips)];
    for (const LegFlexions& leg : legs_) {
      const S knee = select(inverse_weights[leg.knee] > S(0), posture[leg.knee], S(0));
      const S part = knee * S(kOfKnee);
      for (const std::size_t d : {leg.hip, leg.ankle}) {
        reference[d] = part * squats + (posture[d] - part) * leans;
      }
    }
  }

  // The share of its change that a part has made by then.
  [[nodiscard]] S made(TimedPart part, int frame, const S& delay) const {
    const TimeWindow& window = problem_->windows[static_cast<std::size_t>(part)];
    const S tau(window.at(problem_->tau(frame)));
    return minimum_jerk((tau - delay) / (S(1) - delay));
  }

 private:
  const ReachProblem* problem_;
  std::vector<std::size_t> parts_;  // (dofs) the TimedPart of each
  std::vector<LegFlexions> legs_;
};

}  // namespace shigusa
