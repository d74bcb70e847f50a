// SPDX-License-Identifier: MIT
#pragma once

#include "core/index.hpp"
#include "lane_scorer.hpp"
#include "rollout/rollout.hpp"
#include "simd/pack.hpp"

namespace shigusa {

// Scorer for the lanes of one Pack<float, N>. Included only by the source files compiled for a SIMD
// set: each function in it that is not inlined must bear the set's pack in its name, or the linker
// might give other parts of the program code that the machine cannot run
// (scripts/check_simd_symbols.sh).
template <int N>
class PackScorer final : public LaneScorer {
 public:
  using S = Pack<float, N>;

  PackScorer(const ReachProblem& problem, const CriteriaSettings& criteria)
      : rollout_(problem, LostMotion::left),
        criteria_(*problem.body, problem.context, criteria),
        inverse_weights_(problem.body->dofs().size()),
        posture_(inverse_weights_),
        supports_(problem.supports.size()),
        tolerance_(problem.tolerance),
        worst_(worst_score(criteria)) {}

  void score(const MotionInputs& inputs, std::span<double> scores,
             std::span<float> final_angles) override {
    const std::size_t dofs = inverse_weights_.size();
    const int motions = static_cast<int>(scores.size());
    spread(inputs.inverse_weights, motions, inverse_weights_);
    MotionInput<S> input(inverse_weights_);
    if (!inputs.posture.empty()) {
      spread(inputs.posture, motions, posture_);
      spread(inputs.timing, motions, timing_);
      Timing<S> timing;
      for (std::size_t k = 0; k < kTimings; ++k) timing.*kTimingMembers<S>[k] = timing_[k];
      input = {inverse_weights_, posture_, timing};
    }
    if (!inputs.supports.empty()) {
      spread(inputs.supports, motions, supports_);
      input.supports = supports_;
    }
    criteria_.reset();
    const auto outcome =
        rollout_.run(input, [this](const PlacedFrame<S>& frame) { criteria_.add(frame); });
    for (std::size_t k = 0; k < final_angles.size(); ++k) {
      final_angles[k] = rollout_.final_angles()[k % dofs][static_cast<int>(k / dofs)];
    }
    const S result = criteria_.score();
    const auto met = outcome.met(tolerance_);
    for (int lane = 0; lane < motions; ++lane) {
      scores[index(lane)] = met[lane] ? static_cast<double>(result[lane]) : worst_;
    }
  }

 private:
  static int min(int a, int b) { return a < b ? a : b; }

  // Distributes rows (motions × columns) to lanes; unused lanes repeat the last motion.
  static void spread(std::span<const float> rows, int motions, std::span<S> columns) {
    for (int lane = 0; lane < N; ++lane) {
      const float* from = rows.data() + index(min(lane, motions - 1)) * columns.size();
      for (std::size_t d = 0; d < columns.size(); ++d) columns[d].set(lane, from[d]);
    }
  }

  Rollout<S> rollout_;
  BuiltInCriteria<S> criteria_;
  std::vector<S> inverse_weights_;  // (dofs)
  std::vector<S> posture_;          // (dofs)
  S timing_[kTimings];              // in the order of kTimingNumbers
  std::vector<S> supports_;         // (supports)
  ReachTolerance tolerance_;
  double worst_;
};

}  // namespace shigusa
