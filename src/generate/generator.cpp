// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/body/posture_modes.hpp>
#include <shigusa/generate/generator.hpp>
#include <shigusa/generate/layered_problem.hpp>
#include <utility>

#include "candidate.hpp"
#include "delivery.hpp"
#include "joint_progress.hpp"
#include "layered_generator.hpp"
#include "pareto.hpp"
#include "runs.hpp"
#include "searched.hpp"
#include "ways.hpp"

namespace shigusa {
namespace {

// The score in double of what was searched in single precision.
double replayed_score(const ReachProblem& problem, const Task& task, const Parameters& parameters) {
  const RolledOut rolled = play(problem, parameters, task.generator);
  return rolled.outcome.met(problem.tolerance)
             ? score_motion(*problem.body, rolled.motion, task_criteria(task)).total
             : worst_score(task.criteria);
}

// Searches the last of the ways.
void search_best(const Task& task, std::span<const ReachProblem> ways, const Progress& progress,
                 Generation& generation) {
  Searched searched(ways.back(), task);
  const SearchResult found = searched.run(progress);
  generation.evaluations += found.evaluations;
  generation.generations = found.generations;
  generation.rejected_nan += found.rejected_nan;
  generation.end = found.end;
  generation.best_seen = searched.space().decode(found.best_seen.point);
  generation.best_seen_score = replayed_score(ways.back(), task, *generation.best_seen);
  generation.missed = generation.replay_differs = 0;
  generation.replay_difference = 0.0;
  deliver_candidates(task, ways, searched, found, generation);
}

// The one candidate that is given parameters make.
Candidate only_candidate(const Task& task, std::span<const ReachProblem> ways,
                         const Parameters& parameters) {
  Arrival arrival = nearest_arrival(ways, parameters, task.generator);
  return make_candidate(task, *arrival.way, parameters, std::move(arrival.rolled));
}

void finish(const ClosestReach& reach, Generation& generation) {
  const double miss = miss_of(generation.candidates.front());
  const bool met = reach.reached() && miss <= kReachTolerance;
  generation.status = status_of(met, generation.candidates);
  if (met) return;
  double squares = 0.0;
  for (const GoalResult& goal : generation.candidates.front().goals) {
    squares += goal.error * goal.error;
    generation.remaining_turn = max(generation.remaining_turn, goal.turn.error.value_or(0.0));
  }
  generation.remaining_distance = sqrt(squares);
}

// What belongs to one preset is not passed over in silence by another.
Result<void> check_choices(const Task& task) {
  const auto wrong = [&](const char* what) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the preset {} {}", word_of(task.preset), what));
  };
  if (task.pareto && task.preset != Preset::flat) return wrong("knows no Pareto front; flat does");
  if (!traits_of(task.preset).layers) return {};
  if (task.generator != MotionGenerator::weighted_ik) return wrong("knows weighted IK only");
  if (task.own_search) return wrong("takes no search of one's own");
  for (const Goal& goal : task.goals) {
    const auto index = task.body.find_effector(goal.effector);
    if (!index || *index < static_cast<int>(task.body.effectors().size())) continue;
    return wrong("brings hands to their goals; flat takes other joints too");
  }
  if (task.contacts) return wrong("keeps all feet where they are; flat lets one go");
  return {};
}

Result<void> check_fixed(const Task& task, const ReachProblem& problem) {
  if (!task.fixed) return {};
  const Plan plan = whole_body_plan(task.body);
  Parameters values = task.fixed->values;
  if (const auto checked = check_parameters(plan, values); !checked) return checked;
  if (task.fixed->set.size() != parameters_of(plan, values).size()) {
    return fail(ErrorCode::invalid_argument, "fixed parameters are of another body");
  }
  const ParameterSpace space(problem, gene_code(task), task.fixed, task.phases);
  if (space.genes() > 0) return {};
  return fail(ErrorCode::invalid_argument,
              "every parameter is fixed: there is nothing to search, an edit plays them");
}

// Searches the first `most` ways, then one more at a time, until something arrives.
void search_ways(const Task& task, std::span<const ReachProblem> ways, std::size_t most,
                 JointProgress& progress, Generation& generation) {
  for (; most <= ways.size(); ++most) {
    const auto search = task.pareto ? search_front : search_best;
    // where one way does it, as nearly always, that is all
    search(task, ways.first(most), progress.part(1.0), generation);
    if (!generation.candidates.empty() || generation.end == SearchEnd::cancelled) return;
  }
}

// At the edge of reach a goal may be met in a posture that hardly any motion leads to. Then others
// are tried, so many.
constexpr int kOtherGuides = 3;

bool goes_on(const ClosestReach& reach, const Generation& generation) {
  return reach.reached() && generation.candidates.empty() && generation.end != SearchEnd::cancelled;
}

}  // namespace

Task played_task(Task task, const Generation& generation) {
  if (generation.slowed) task.duration = generation.duration;
  return task;
}

namespace {

// One search, of a task that is prepared.
Result<Generation> search_task(const Task& task, const Progress& progress) {
  if (traits_of(task.preset).layers) return generate_layered(task, progress);
  const Result<ReachProblem> problem = make_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  if (const auto checked = check_fixed(task, *problem); !checked) {
    return tl::unexpected(checked.error());
  }
  const ClosestReach reach = closest_reach(*problem);
  const std::vector<ReachProblem> ways = ways_to_goal(*problem, reach);
  Generation generation;
  generation.duration = problem->duration;
  JointProgress joint(progress);
  search_ways(task, ways, 1, joint, generation);
  for (int other = 1; other <= kOtherGuides && goes_on(reach, generation); ++other) {
    const ClosestReach again = closest_reach(*problem, {.other = other});
    if (!again.reached()) continue;
    search_ways(task, ways_to_goal(*problem, again), 2, joint, generation);
  }
  Task other = task;
  while (reach.reached() && runs_again(task, generation)) {
    other.genetic.stream = static_cast<std::uint64_t>(generation.runs);
    Generation run;
    search_ways(other, ways, 1, joint, run);
    add_run(task, std::move(run), generation);
  }
  if (generation.candidates.empty()) {
    generation.candidates.push_back(only_candidate(task, ways, uniform_parameters(task.body)));
  }
  finish(reach, generation);
  return generation;
}

// The least duration (s) in which a candidate is possible that is not so only for its haste.
std::optional<double> possible_duration(const Generation& generation) {
  std::optional<double> least;
  for (const Candidate& candidate : generation.candidates) {
    const std::optional<double>& own = candidate.judgement.possible_in;
    if (own && (!least || *own < *least)) least = own;
  }
  return least;
}

// The candidates as the task plays them, which has another duration.
Result<Generation> played_anew(const Task& task, const Generation& generation) {
  Generation again = generation;
  again.duration = *task.duration;
  again.candidates.clear();
  for (const Candidate& candidate : generation.candidates) {
    Result<Generation> one = regenerate(task, candidate.parameters);
    if (!one) return one;
    again.candidates.push_back(std::move(one.value().candidates.front()));
  }
  std::stable_sort(again.candidates.begin(), again.candidates.end(), ranks_before);
  again.status = status_of(generation.meets_goals(), again.candidates);
  return again;
}

bool wants_more(const Generation& generation) {
  return generation.status == ReachStatus::unsteady && generation.end != SearchEnd::cancelled;
}

// Another search of the same task takes the place of one that found nothing possible, if it did.
bool take_place(Generation other, Generation& found) {
  found.evaluations += other.evaluations;
  found.end = other.end;
  if (other.status != ReachStatus::reached) return false;
  other.evaluations = found.evaluations;
  found = std::move(other);
  return true;
}

// Where motions are impossible only for their haste, and the task gives no duration, it takes
// longer.
void try_slower(const Task& task, JointProgress& progress, Generation& found) {
  const std::optional<double> duration = possible_duration(found);
  if (!wants_more(found) || task.duration || !duration) return;
  Task slower = task;
  slower.duration = duration;
  // a budget that was given is used up
  const bool spent = task.evaluations.has_value();
  const int evaluations = found.evaluations;
  Result<Generation> again =
      spent ? played_anew(slower, found) : search_task(slower, progress.part(1.0));
  if (again && take_place(std::move(*again), found)) found.slowed = true;
  if (spent) found.evaluations = evaluations;
}

// How many times as many motions are scored where nothing that was found is possible.
constexpr int kLongerSearch = 3;

void try_longer(const Task& task, JointProgress& progress, Generation& found) {
  if (!wants_more(found) || task.evaluations) return;
  Task longer = task;
  longer.evaluations = kLongerSearch * usual_evaluations(task);
  Result<Generation> again = search_task(longer, progress.part(1.0));
  if (again) take_place(std::move(*again), found);
}

}  // namespace

Result<void> check_task(const Task& task) {
  if (const auto checked = check_choices(task); !checked) return checked;
  if (needs_preparing(task)) {
    const Result<Task> ready = prepared(task);
    return ready ? check_task(*ready) : tl::unexpected(ready.error());
  }
  const Result<ReachProblem> problem = make_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  if (!traits_of(task.preset).layers) return check_fixed(task, *problem);
  const Result<Plan> layers = layers_of(task);
  return layers ? Result<void>{} : tl::unexpected(layers.error());
}

Result<Generation> generate(const Task& task, const Progress& progress) {
  if (const auto checked = check_choices(task); !checked) return tl::unexpected(checked.error());
  if (needs_preparing(task)) {
    const Result<Task> ready = prepared(task);
    return ready ? generate(*ready, progress) : tl::unexpected(ready.error());
  }
  JointProgress joint(progress);
  Result<Generation> found = search_task(task, joint.part(1.0));
  if (found && traits_of(task.preset).natural) {
    try_slower(task, joint, *found);
    try_longer(task, joint, *found);
  }
  return found;
}

Result<Generation> regenerate(const Task& task, const Parameters& parameters) {
  if (needs_preparing(task)) {
    const Result<Task> ready = prepared(task);
    return ready ? regenerate(*ready, parameters) : tl::unexpected(ready.error());
  }
  if (traits_of(task.preset).layers) return regenerate_layered(task, parameters);
  const Result<ReachProblem> problem = make_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  if (const auto checked = check_parameters(whole_body_plan(task.body), parameters); !checked) {
    return tl::unexpected(checked.error());
  }
  const ClosestReach reach = closest_reach(*problem);
  const std::vector<ReachProblem> ways = ways_to_goal(*problem, reach);
  Generation generation;
  generation.duration = problem->duration;
  generation.candidates.push_back(only_candidate(task, ways, parameters));
  for (int other = 1; other <= kOtherGuides && reach.reached(); ++other) {
    if (miss_of(generation.candidates.front()) <= kReachTolerance) break;
    const ClosestReach again = closest_reach(*problem, {.other = other});
    if (!again.reached()) continue;
    Candidate candidate = only_candidate(task, ways_to_goal(*problem, again), parameters);
    if (miss_of(candidate) <= kReachTolerance) generation.candidates.front() = std::move(candidate);
  }
  finish(reach, generation);
  return generation;
}

}  // namespace shigusa
