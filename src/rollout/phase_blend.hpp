// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/scalar.hpp>
#include <span>
#include <vector>

#include "motion/minimum_jerk.hpp"
#include "rollout/motion_input.hpp"

namespace shigusa {

// Share of the duration that a change from one phase to the next takes, half of it before
// switch_at. Joints change their speeds with the weights: random motions change a joint's step by
// as much from frame to frame as those of one phase do (0.7° in the median; over a window of 0.2 by
// 1.1°). And from kSwitchMin to kSwitchMax all of it is within the motion.
inline constexpr double kSwitchWindow = 0.4;

// Weights and posture of a motion in two phases, step by step. The share b of the later phase goes
// from 0 to 1 along the minimum-jerk profile over the window:
//
//   1 / w = ((1 - b) (1 / w_first)^¼ + b (1 / w_later)^¼)⁴,   posture = (1 - b) first + b later
//
// Blended as they are, inverse weights that are e^11 apart would change places in the last tenth of
// the window; in their logarithms they would do so evenly, but a locked joint has none. Fourth
// roots are nearly as even, have a 0, and take no exponential. A freedom that is locked in one
// phase is not drawn anywhere there.
template <class S>
class PhaseBlend {
 public:
  explicit PhaseBlend(std::size_t dofs)
      : roots_(dofs),
        later_roots_(dofs),
        first_(dofs),
        later_(dofs),
        weights_(dofs),
        posture_(dofs) {}

  // Before the first step of a motion that has a later phase.
  void begin(const MotionInput<S>& input) {
    for (std::size_t d = 0; d < weights_.size(); ++d) {
      const S weight = input.inverse_weights[d];
      const S later_weight = input.later.inverse_weights[d];
      roots_[d] = sqrt(sqrt(weight));
      later_roots_[d] = sqrt(sqrt(later_weight));
      if (input.posture.empty()) continue;
      first_[d] = select(weight > S(0), input.posture[d], S(0));
      later_[d] = select(later_weight > S(0), input.later.posture[d], S(0));
    }
  }

  // Blends both phases for the step in whose middle the share `tau` of the duration is over.
  // Returns b.
  S step(const MotionInput<S>& input, double tau) {
    const S share =
        minimum_jerk((S(tau) - input.later.switch_at) * S(1.0 / kSwitchWindow) + S(0.5));
    for (std::size_t d = 0; d < weights_.size(); ++d) {
      const S root = roots_[d] + (later_roots_[d] - roots_[d]) * share;
      const S square = root * root;
      // outside the window, and where both are the same, to the last bit as given
      const S first = input.inverse_weights[d];
      const S later = input.later.inverse_weights[d];
      const auto changing = (share > S(0)) & (abs(later - first) > S(0));
      weights_[d] = select(share < S(1), select(changing, square * square, first), later);
      posture_[d] = first_[d] + (later_[d] - first_[d]) * share;
    }
    return share;
  }

  // Weights and posture of the last step.
  [[nodiscard]] std::span<const S> inverse_weights() const { return weights_; }  // (dofs)
  [[nodiscard]] std::span<const S> posture() const { return posture_; }          // (dofs) rad

 private:
  std::vector<S> roots_;  // (dofs) fourth roots of the inverse weights, of the first phase …
  std::vector<S> later_roots_;  // … and of the later
  std::vector<S> first_;        // (dofs, rad) change of posture, of the first phase …
  std::vector<S> later_;        // … and of the later
  std::vector<S> weights_;
  std::vector<S> posture_;
};

}  // namespace shigusa
