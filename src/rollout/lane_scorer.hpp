// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "rollout/batch_rollout.hpp"

namespace shigusa {

// Scores as many motions in parallel as a SIMD set has lanes. One object per thread.
class LaneScorer {
 public:
  virtual ~LaneScorer() = default;
  // Scores at most simd_lanes() motions: scores (motions), final_angles (motions × dofs) or empty.
  virtual void score(const MotionInputs& inputs, std::span<double> scores,
                     std::span<float> final_angles) = 0;
};

// One per SIMD set, each in a source file compiled for it.
std::unique_ptr<LaneScorer> make_scalar_scorer(const ReachProblem& problem,
                                               const CriteriaSettings& criteria);
std::unique_ptr<LaneScorer> make_lanes_4_scorer(const ReachProblem& problem,
                                                const CriteriaSettings& criteria);
std::unique_ptr<LaneScorer> make_avx2_scorer(const ReachProblem& problem,
                                             const CriteriaSettings& criteria);
std::unique_ptr<LaneScorer> make_avx512_scorer(const ReachProblem& problem,
                                               const CriteriaSettings& criteria);

}  // namespace shigusa
