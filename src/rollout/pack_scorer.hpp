// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/rollout/rollout.hpp>
#include <shigusa/simd/pack.hpp>

#include "lane_scorer.hpp"

namespace shigusa {

// The lanes of one Pack<float, N>. Included only by the source files that are compiled for a SIMD
// set: everything in it that is not inlined must bear the set's pack in its name, or the linker
// might give another part of the program code that the machine cannot run
// (scripts/check_simd_symbols.sh).
template <int N>
class PackScorer final : public LaneScorer {
 public:
  using S = Pack<float, N>;

  PackScorer(const ReachProblem& problem, const CriteriaSettings& criteria)
      : rollout_(problem),
        criteria_(*problem.body, criteria),
        inverse_weights_(problem.body->dofs().size()),
        tolerance_(problem.tolerance),
        worst_(worst_score(criteria)) {}

  void score(std::span<const float> inverse_weights, std::span<double> scores) override {
    const std::size_t dofs = inverse_weights_.size();
    const int motions = static_cast<int>(scores.size());
    // lanes that are left over repeat the last motion
    for (int lane = 0; lane < N; ++lane) {
      const float* from =
          inverse_weights.data() + static_cast<std::size_t>(min(lane, motions - 1)) * dofs;
      for (std::size_t d = 0; d < dofs; ++d) inverse_weights_[d].set(lane, from[d]);
    }
    criteria_.reset();
    const auto outcome = rollout_.run(
        inverse_weights_,
        [this](const MotionFrame<S>& frame, const Kinematics<S>&) { criteria_.add(frame); });
    const S result = criteria_.score();
    const auto met = outcome.met(tolerance_);
    for (int lane = 0; lane < motions; ++lane) {
      scores[static_cast<std::size_t>(lane)] =
          met[lane] ? static_cast<double>(result[lane]) : worst_;
    }
  }

 private:
  static int min(int a, int b) { return a < b ? a : b; }

  Rollout<S> rollout_;
  BuiltInCriteria<S> criteria_;
  std::vector<S> inverse_weights_;  // (dofs)
  ReachTolerance tolerance_;
  double worst_;
};

}  // namespace shigusa
