// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "approaches.hpp"
#include "candidate.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "generate/start_table.hpp"
#include "planner.hpp"
#include "rollout/smooth_motion.hpp"
#include "task/make_problem.hpp"
#include "task/task_supports.hpp"
#include "whole_body_search.hpp"

namespace shigusa {
namespace {

// Postures beside the archive's best that a search delivers from, for each candidate asked for.
constexpr int kKeptPerCandidate = 4;

Result<void> check_fixed(const Task& task, const ReachProblem& problem) {
  if (!task.fixed) return {};
  const Plan plan = whole_body_plan(task.body, task.supports);
  Parameters values = task.fixed->values;
  SHG_TRY(check_parameters(plan, values));
  if (task.fixed->set.size() != parameters_of(plan, values).size()) {
    return fail(ErrorCode::invalid_argument, say("fixed_of_another"));
  }
  const ParameterSpace space(problem, gene_code(task), task.fixed, task.phases);
  if (space.genes() > 0) return {};
  return fail(ErrorCode::invalid_argument, say("all_fixed"));
}

Result<void> check_starts(const Task& task) {
  const Plan plan = whole_body_plan(task.body, task.supports);
  for (std::size_t k = 0; k < task.starts.size(); ++k) {
    const Result<void> good = check_parameters(plan, task.starts[k]);
    if (good) continue;
    const Error& error = good.error();
    const std::string place = fmt::format("starts[{}]", k);
    return fail(error.code, error.message,
                error.place.empty() ? place : place + ": " + error.place);
  }
  return {};
}

// Fails where values that a person gives are of another body, or leave nothing to search.
Result<void> check_values(const Task& task, const ReachProblem& problem) {
  SHG_TRY(check_starts(task));
  return check_fixed(task, problem);
}

bool goes_around(const ReachProblem& problem) {
  return std::any_of(problem.goals.begin(), problem.goals.end(),
                     [](const ReachGoal& goal) { return goal.path.detour != Vec3d{}; });
}

// The best score of what a search would begin at.
double best_start(const ReachProblem& problem, const Task& task) {
  const CriteriaSettings criteria = task_criteria(task);
  const ParameterSpace space(problem, gene_code(task), task.fixed, task.phases);
  std::vector<double> points = known_starts(problem, space, task.starts);
  const std::vector<double> bent = bent_starts(space);
  points.insert(points.end(), bent.begin(), bent.end());
  std::vector<double> scores(points.size() / index(std::max(space.genes(), 1)));
  PointScorer(problem, task, criteria, space, task.batch.threads).score(points, scores);
  double best = worst_score(criteria);
  for (const double score : scores) best = score < best ? score : best;
  return best;
}

// The way without a detour is worth a search where it scores less than this share of the detour's
// score.
constexpr double kStraightShare = 0.9;

// The approaches by a detour where one is needed: motions of uniform weights tell of one that the
// best motions from the start table may do without.
std::vector<ReachProblem> usual_approaches(const Task& task, const ReachProblem& problem,
                                           const ClosestReach& reach) {
  std::vector<ReachProblem> around = approaches_to_goal(problem, reach);
  const bool natural = traits_of(task.preset).natural && !task.own_search &&
                       !scores_whole_motions(task, task_criteria(task));
  if (!natural || !goes_around(around.front()) || !check_values(task, problem)) return around;
  std::vector<ReachProblem> straight = approaches_to_goal(problem, reach, true);
  const bool does_without =
      best_start(straight.front(), task) < kStraightShare * best_start(around.front(), task);
  return does_without ? straight : around;
}

class WholeBodyPlanner : public Planner {
 public:
  WholeBodyPlanner(const Task& task, ReachProblem problem)
      : task_(task),
        plan_(whole_body_plan(task.body, task.supports)),
        problem_(std::move(problem)) {
    ClosestReach reach = closest_reach(problem_);
    in_reach_ = reach.reached();
    if (!in_reach_ && traits_of(task.preset).natural) {
      // people stop before a hand is in their own body
      problem_ = clear_goals(problem_, reach);
      reach = closest_reach(problem_);
    }
    usual_approaches_ = usual_approaches(task_, problem_, reach);
    approaches_ = usual_approaches_;
  }

  [[nodiscard]] std::span<const Layer> plan() const override { return plan_; }
  [[nodiscard]] double duration() const override { return problem_.duration; }
  [[nodiscard]] bool in_reach() const override { return in_reach_; }
  [[nodiscard]] Result<void> check_search() const override { return check_values(task_, problem_); }
  [[nodiscard]] std::size_t approaches() const override { return approaches_.size(); }

  bool go_by_other_posture(int other) override {
    if (other == 0) {
      approaches_ = usual_approaches_;
      return true;
    }
    const ClosestReach reach = closest_reach(problem_, {.other = other});
    if (!reach.reached()) return false;
    approaches_ = approaches_to_goal(problem_, reach);
    return true;
  }

  Found search(const Task& task, std::size_t approach, const Progress& progress) override {
    const ReachProblem& problem = approaches_[approach];
    WholeBodySearch searched(problem, task);
    Found found{.result = searched.run(progress), .selection = {}, .best_seen = {}};
    space_ = searched.space();
    found.selection =
        traits_of(task.preset).natural
            ? distinct_postures(searched.archive(), kKeptPerCandidate * task.candidates)
            : Selection{.picked = ranked_population(found.result)};
    found.best_seen = space_->decode(found.result.best_seen.point);
    found.best_seen_score = replayed_score(problem, found.best_seen);
    return found;
  }

  Expanded expand(std::span<const double> point) override {
    return {.values = space_->decode(point)};
  }

  [[nodiscard]] std::optional<Arrival> arrival(const Parameters& values,
                                               std::size_t last) const override {
    auto arrival = first_arrival(std::span(approaches_).first(last + 1), values, task_.generator);
    if (arrival) arrival->as_searched = arrival->approach == &approaches_[last];
    return arrival;
  }

  [[nodiscard]] Arrival nearest(const Parameters& values) const override {
    return nearest_arrival(approaches_, values, task_.generator);
  }

  [[nodiscard]] Candidate candidate(const Expanded& expanded, Arrival arrival) const override {
    const ReachProblem& problem = *arrival.approach;
    const bool smooths = problem.smooth && task_.generator == MotionGenerator::weighted_ik;
    RolledOut rolled = smooths ? smoothed(problem, expanded.values, std::move(arrival.rolled))
                               : std::move(arrival.rolled);
    return make_candidate(task_, problem, expanded.values, std::move(rolled));
  }

  void finish(GenerateResult& /*generation*/) override {}

 private:
  // The score in double of values that were searched in single precision.
  [[nodiscard]] double replayed_score(const ReachProblem& problem, const Parameters& values) const {
    const RolledOut rolled = play(problem, values, task_.generator);
    return rolled.outcome.met(problem.tolerance)
               ? score_motion(task_.body, rolled.motion, task_criteria(task_)).total
               : worst_score(task_.criteria);
  }

  const Task& task_;
  Plan plan_;
  ReachProblem problem_;
  bool in_reach_ = false;
  std::vector<ReachProblem> usual_approaches_;
  std::vector<ReachProblem> approaches_;
  std::optional<ParameterSpace> space_;  // of the last search
};

}  // namespace

Result<std::unique_ptr<Planner>> make_whole_body_planner(const Task& task) {
  SHG_TRY_ASSIGN(ReachProblem problem, make_problem(task));
  SHG_TRY(settle_supports(task, problem));
  return std::make_unique<WholeBodyPlanner>(task, std::move(problem));
}

Result<std::unique_ptr<Planner>> make_planner(const PreparedTask& task) {
  return traits_of(task.preset).layers ? make_layered_planner(task) : make_whole_body_planner(task);
}

Result<void> check_plan(const PreparedTask& task) {
  SHG_TRY_ASSIGN(const ReachProblem problem, make_problem(task));
  if (!traits_of(task.preset).layers) return check_values(task, problem);
  return check_layers(task);
}

}  // namespace shigusa
