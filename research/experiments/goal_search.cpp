// SPDX-License-Identifier: MIT
#include "goal_search.hpp"

#include <algorithm>
#include <shigusa/run.hpp>

#include "problem/make_problem.hpp"
#include "problem/reachability.hpp"
#include "rollout/detour.hpp"
#include "rollout/rollout.hpp"

namespace shigusa::bench {
namespace {

constexpr int kProbed = 256;

}  // namespace

Task goal_task(const PosedBody& posed, const Vec3d& goal, Preset preset,
               const CriteriaSettings& criteria) {
  Task task = with_preset(Task(posed, {.goals = {{"right_hand", goal}}}), preset);
  task.criteria = criteria;
  task.batch.threads = 1;
  return task;
}

GoalSearch::GoalSearch(const PosedBody& posed, const Vec3d& goal,
                       const GoalSearchSettings& settings)
    : task_(goal_task(posed, goal, Preset::flat, settings.criteria)),
      reach_(make_problem(task_).value()),
      criteria_(task_.criteria),
      list_(parameter_list(task_.body, task_.start, task_).value()) {
  const ClosestReach closest = closest_reach(reach_);
  add_detours(reach_);
  reach_.steps = settings.steps;
  space_.emplace(reach_, list_, settings.code, task_.fixed);
  batch_.emplace(reach_, criteria_, task_.batch);
  if (any_arrives()) return;
  reach_.guide = closest.angles;
  batch_.emplace(reach_, criteria_, task_.batch);
  if (any_arrives()) return;
  reach_.follow_path = false;
  batch_.emplace(reach_, criteria_, task_.batch);
}

bool GoalSearch::any_arrives() {
  Random random(1);
  std::vector<double> points = space_->start();
  while (static_cast<int>(points.size()) < kProbed * space_->genes()) {
    points.push_back(random.uniform());
  }
  std::vector<double> scores(kProbed);
  batch_->score(space_->rows(points), scores);
  const double worst = worst_score(criteria_);
  return std::any_of(scores.begin(), scores.end(), [&](double score) { return score < worst; });
}

SearchProblem GoalSearch::problem() {
  return {
      .genes = space_->genes(),
      .evaluate = [this](std::span<const double> points,
                         std::span<double> scores) { batch_->score(space_->rows(points), scores); },
      .start = space_->start()};
}

double GoalSearch::replayed(std::span<const double> point) const {
  const RolledOut rolled = roll_out(reach_, space_->decode(point));
  return rolled.outcome.met(reach_.tolerance)
             ? score_motion(task_.body, rolled.motion, criteria_, reach_.context).total
             : worst_score(criteria_);
}

SearchProblem BestAt::watch(SearchProblem problem) {
  const auto inner = problem.evaluate;
  problem.evaluate = [this, inner](std::span<const double> points, std::span<double> scores) {
    inner(points, scores);
    for (const double score : scores) note(score);
  };
  return problem;
}

void BestAt::note(double score) {
  now_ = std::min(now_, score);
  ++scored_;
  if (best_.size() < budgets_.size() && scored_ == budgets_[best_.size()]) best_.push_back(now_);
}

std::vector<double> BestAt::best() const {
  std::vector<double> best = best_;
  best.resize(budgets_.size(), now_);
  return best;
}

}  // namespace shigusa::bench
