// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/request.hpp>
#include <span>
#include <vector>

#include "generate/archive.hpp"
#include "generate/parameter_space.hpp"
#include "problem/problem.hpp"
#include "rollout/batch_rollout.hpp"

namespace shigusa {

// The squat that a person has fixed, as the knees' flexion at the end. Weights and the other modes
// leave more or less of it, so that the score says how much.
class SquatTarget {
 public:
  // None where the task fixes no squat.
  static std::optional<SquatTarget> of(const Problem& problem);

  // How far (rad) the mean of the knees' angles is off.
  [[nodiscard]] double off(std::span<const float> angles) const;

 private:
  std::vector<std::size_t> knees_;
  double wanted_ = 0.0;  // rad, of all knees together
};

// Scores the points of one island, and keeps the postures that their motions end in.
// Problem, approach and criteria outlive it.
class PointScorer {
 public:
  // `threads` as BatchSettings has them (0: one for each core).
  PointScorer(const Problem& problem, const ReachProblem& approach,
              const CriteriaSettings& criteria, const ParameterSpace& space, int threads);

  // Scores points (motions × genes) → scores (motions), lower is better, and adds the cost of
  // missing a fixed squat.
  void score(std::span<const double> points, std::span<double> scores);

  [[nodiscard]] const Archive& archive() const { return archive_; }

 private:
  void score_one_by_one(std::span<const double> points, std::span<double> scores);

  const Task& task_;
  const ReachProblem& approach_;
  const CriteriaSettings& criteria_;
  ParameterSpace space_;  // has scratch memory of its own
  int threads_;
  BatchRollout batch_;
  Archive archive_;
  std::optional<SquatTarget> squat_;
  std::vector<float> angles_;        // (motions × dofs) rad, where they end
  std::vector<double> kept_scores_;  // (motions), without what is added
};

// Whether motions are scored one by one: criteria of the user's own want whole motions, and NLP-IK
// has no lanes.
[[nodiscard]] bool scores_whole_motions(const Task& task, const CriteriaSettings& criteria);

}  // namespace shigusa
