// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <shigusa/run.hpp>
#include <span>
#include <vector>

#include "criteria/built_in_criteria.hpp"
#include "plan/motion_input.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

class LaneScorer;

// Scores batches of motions by the built-in criteria, one motion in each lane of a vector register,
// on all cores, in single precision. A motion's score depends on its parameters alone.
class BatchRollout {
 public:
  // A motion outside the problem's tolerance gets worst_score(criteria). Problem and criteria
  // outlive the batch. PreconditionError if the machine lacks the SIMD set.
  BatchRollout(const ReachProblem& problem, const CriteriaSettings& criteria,
               const BatchSettings& settings = {});
  ~BatchRollout();
  BatchRollout(const BatchRollout&) = delete;
  BatchRollout& operator=(const BatchRollout&) = delete;

  // Scores a batch of motions. scores (motions), lower is better. final_angles (motions × dofs,
  // rad): the posture at the end of each motion; may be empty.
  void score(const MotionInputs& inputs, std::span<double> scores,
             std::span<float> final_angles = {});

 private:
  const ReachProblem* problem_;
  const CriteriaSettings* criteria_;
  BatchSettings settings_;
  std::vector<std::unique_ptr<LaneScorer>> scorers_;  // one per thread, made on demand
};

}  // namespace shigusa
