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

// A squat fixed by the user, as the knees' flexion in the last frame. Weights and the other modes
// change it, so the score penalises the difference.
class SquatTarget {
 public:
  // None if the task fixes no squat.
  static std::optional<SquatTarget> of(const Problem& problem);

  // Error (rad) of the mean knee angle.
  [[nodiscard]] double off(std::span<const float> angles) const;

 private:
  std::vector<std::size_t> knees_;
  double wanted_ = 0.0;  // rad, sum over the knees
};

// Scores the points of one island, and archives the final postures of their motions. Problem,
// approach and criteria outlive it.
class PointScorer {
 public:
  // `threads`: see BatchSettings (0: one per core).
  PointScorer(const Problem& problem, const ReachProblem& approach,
              const CriteriaSettings& criteria, const ParameterSpace& space, int threads);

  // Scores points (motions × genes) → scores (motions), lower is better, including the cost of
  // missing a fixed squat.
  void score(std::span<const double> points, std::span<double> scores);

  [[nodiscard]] const Archive& archive() const { return archive_; }

 private:
  void score_motions_of(std::span<const double> points, std::span<double> scores);

  const Task& task_;
  const ReachProblem& approach_;
  const CriteriaSettings& criteria_;
  ParameterSpace space_;  // own copy, as it has scratch memory
  int threads_;
  BatchRollout batch_;
  Archive archive_;
  std::optional<SquatTarget> squat_;
  std::vector<float> angles_;        // (motions × dofs) rad, in the last frame
  std::vector<double> kept_scores_;  // (motions), without the squat cost
};

// Whether motions are scored whole: user criteria take whole motions, and NLP-IK has no lanes.
[[nodiscard]] bool scores_whole_motions(const Task& task, const CriteriaSettings& criteria);

}  // namespace shigusa
