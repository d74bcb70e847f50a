// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/request.hpp>
#include <shigusa/search.hpp>

#include "generate/parameter_space.hpp"
#include "rollout/batch_rollout.hpp"

namespace shigusa::bench {

struct GoalSearchSettings {
  CriteriaSettings criteria = default_criteria();
  GeneCode code = GeneCode::natural;
  int steps = kMotionSteps;
};

// The search of generate() for one goal of the right hand with the preset flat, with access to its
// problem, space and scores, without candidates. Its approach is the first by which one of some
// random motions arrives: the straight path with its detour; that path with the null space
// attracted to a posture at the goal; that posture alone.
class GoalSearch {
 public:
  GoalSearch(const PosedBody& body, const Vec3d& goal, const GoalSearchSettings& settings = {});
  GoalSearch(const GoalSearch&) = delete;
  GoalSearch& operator=(const GoalSearch&) = delete;

  // Evaluator on the calling thread; points into this object.
  [[nodiscard]] SearchProblem problem();

  [[nodiscard]] const ReachProblem& reach() const { return reach_; }
  [[nodiscard]] const ParameterSpace& space() const { return *space_; }
  [[nodiscard]] const CriteriaSettings& criteria() const { return criteria_; }
  // Score in double; the worst one if the goal is missed.
  [[nodiscard]] double replayed(std::span<const double> point) const;

 private:
  [[nodiscard]] bool any_arrives();

  Task task_;
  ReachProblem reach_;
  CriteriaSettings criteria_;
  ParameterList list_;
  std::optional<ParameterSpace> space_;
  std::optional<BatchRollout> batch_;
};

// Task of one goal for the right hand, on one thread.
[[nodiscard]] Task goal_task(const PosedBody& body, const Vec3d& goal, Preset preset,
                             const CriteriaSettings& criteria);

// Best score among the first b evaluated points of a search, for each budget b.
class BestAt {
 public:
  explicit BestAt(std::vector<int> budgets) : budgets_(std::move(budgets)) {}

  // The problem with its scores recorded; points into this object and takes over `problem`.
  [[nodiscard]] SearchProblem watch(SearchProblem problem);
  void note(double score);

  // (budgets) a search that ended before keeps its last best.
  [[nodiscard]] std::vector<double> best() const;

 private:
  std::vector<int> budgets_;
  std::vector<double> best_;  // at the budgets that were passed
  double now_ = 1e300;
  int scored_ = 0;
};

}  // namespace shigusa::bench
