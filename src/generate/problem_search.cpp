// SPDX-License-Identifier: MIT
#include "problem_search.hpp"

#include <algorithm>
#include <utility>

#include "candidate.hpp"
#include "core/say.hpp"
#include "delivery.hpp"
#include "distinct.hpp"
#include "joint_progress.hpp"
#include "pareto.hpp"

namespace shigusa {
namespace {

// Searches on one approach, and delivers the candidates.
void search_best(const Task& task, const RunSettings& run, Planner& planner, std::size_t approach,
                 const Progress& progress, GenerateResult& generation) {
  Found found = planner.search(run, approach, progress);
  add_counts(found.result, generation);
  generation.best_seen = found.best_seen;
  generation.best_seen_score = found.best_seen_score;
  deliver_candidates(task, planner, approach, std::move(found), generation);
}

// The candidate of the given values.
Candidate only_candidate(const Planner& planner, const Parameters& values) {
  return planner.candidate({.values = values}, planner.nearest(values));
}

// The approaches to search, in order.
struct Approaches {
  std::size_t first = 0;
  // All of them, unless the first leads to a possible motion; otherwise until one arrives.
  bool all = false;
};

bool has_possible(const GenerateResult& generation) {
  return status_of(true, generation.candidates) == ReachStatus::reached;
}

// Whether the best candidate of one approach is better than another's, possible ones first.
bool is_better(const GenerateResult& one, const GenerateResult& other) {
  if (other.candidates.empty()) return true;
  if (one.candidates.empty()) return false;
  if (has_possible(one) != has_possible(other)) return has_possible(one);
  return one.candidates.front().score.total < other.candidates.front().score.total;
}

// Adds another approach's search, and takes its candidates if they are better.
void add_approach(GenerateResult other, GenerateResult& generation) {
  const SearchEnd end = other.end;
  if (is_better(other, generation)) std::swap(other, generation);
  generation.log.spend(other.log);
  generation.end = end;
}

// Searches on the approaches until one arrives, nearly always the first.
void search_approaches(const Task& task, const RunSettings& run, Planner& planner,
                       const Approaches& approaches, JointProgress& progress,
                       GenerateResult& generation) {
  const auto search = task.pareto ? search_front : search_best;
  for (std::size_t k = approaches.first; k < planner.approaches(); ++k) {
    GenerateResult other;
    other.duration = generation.duration;
    search(task, run, planner, k, progress.part(1.0), other);
    add_approach(std::move(other), generation);
    if (generation.end == SearchEnd::cancelled) return;
    if (generation.candidates.empty()) continue;
    if (!approaches.all || (k == 0 && has_possible(generation))) return;
  }
}

// Other postures tried if no motion arrives by the first posture at the edge of reach.
constexpr int kOtherPostures = 3;

// Distinct candidates from which a person chooses in the paper (section 4.1).
constexpr int kPaperCandidates = 3;

// Whether a search is repeated with other random numbers: for the preset paper, whose genetic
// algorithm often converges to identical genomes, if the task sets no number of motions; until
// there are kPaperCandidates candidates, or as many as the task asks for, or after Task::most_runs
// runs.
bool runs_again(const Task& task, const RunSettings& run, const GenerateResult& generation) {
  if (task.preset != Preset::paper || run.evaluations || task.own_search) return false;
  if (task.search.value_or(SearchMethod::paper_ga) != SearchMethod::paper_ga) return false;
  if (generation.end == SearchEnd::cancelled || generation.log.runs >= task.most_runs) return false;
  return static_cast<int>(generation.candidates.size()) < min(kPaperCandidates, task.candidates);
}

// Adds the candidates of another run, without copies of present ones.
void take_in(std::vector<Candidate> candidates, GenerateResult& generation) {
  std::vector<Candidate>& all = generation.candidates;
  for (Candidate& candidate : candidates) {
    const bool is_copy = std::any_of(all.begin(), all.end(), [&candidate](const Candidate& other) {
      return largest_distance(other.motion.clip, candidate.motion.clip) < kDistinctPosture;
    });
    if (is_copy) {
      ++generation.log.near_copies;
    } else {
      all.push_back(std::move(candidate));
    }
  }
}

// Adds another run to the result.
void add_run(const Task& task, GenerateResult run, GenerateResult& generation) {
  generation.log.add_run(run.log);
  generation.end = run.end;
  if (run.best_seen_score < generation.best_seen_score) {
    generation.best_seen = std::move(run.best_seen);
    generation.best_seen_score = run.best_seen_score;
  }
  take_in(std::move(run.candidates), generation);
  std::vector<Candidate>& all = generation.candidates;
  std::stable_sort(all.begin(), all.end(), ranks_of(task));
  const auto most = static_cast<std::size_t>(task.candidates);
  if (all.size() > most) all.erase(all.begin() + task.candidates, all.end());
  generation.fewer = {};
  if (all.size() == most) return;
  generation.fewer = say("fewer_runs", all.size(), task.candidates, generation.log.runs);
}

}  // namespace

void find_possible_in(const BodyModel& body, GenerateResult& generation) {
  for (Candidate& candidate : generation.candidates) {
    Judgement& judgement = candidate.judgement;
    if (judgement.possible_in) continue;
    judgement.possible_in = possible_in(judgement, body, candidate.motion, candidate.measures);
  }
}

void tell_status(bool in_reach, GenerateResult& generation) {
  const Candidate& best = generation.candidates.front();
  const bool met = in_reach && miss_of(best) <= kReachTolerance;
  generation.status = status_of(met, generation.candidates);
  if (met) return;
  double squares = 0.0;
  for (const GoalResult& goal : best.goals) {
    squares += goal.error * goal.error;
    generation.remaining_turn = max(generation.remaining_turn, goal.turn.error.value_or(0.0));
  }
  generation.remaining_distance = sqrt(squares);
}

Result<GenerateResult> search_problem(const Problem& problem, const RunSettings& run,
                                      const Progress& progress, bool on_all) {
  const Task& task = problem.task;
  SHG_TRY_ASSIGN(const std::unique_ptr<Planner> made, make_planner(problem));
  Planner& planner = *made;
  SHG_TRY(check_values(problem));
  GenerateResult generation;
  generation.duration = problem.reach.duration;
  JointProgress joint(progress);
  search_approaches(task, run, planner, {.all = on_all}, joint, generation);
  for (int other = 1; other <= kOtherPostures && planner.in_reach(); ++other) {
    if (!generation.candidates.empty() || generation.end == SearchEnd::cancelled) break;
    if (planner.go_by_other_posture(other)) {
      search_approaches(task, run, planner, {.first = 1}, joint, generation);
    }
  }
  planner.go_by_other_posture(0);
  RunSettings other = run;
  while (planner.in_reach() && runs_again(task, run, generation)) {
    other.stream = static_cast<std::uint64_t>(generation.log.runs);
    GenerateResult again;
    search_approaches(task, other, planner, {}, joint, again);
    add_run(task, std::move(again), generation);
  }
  if (generation.candidates.empty()) {
    generation.candidates.push_back(only_candidate(planner, problem.parameters->start()));
  }
  std::stable_sort(generation.candidates.begin(), generation.candidates.end(), ranks_of(task));
  find_possible_in(task.body, generation);
  tell_status(planner.in_reach(), generation);
  planner.finish(generation);
  return generation;
}

Candidate played(Planner& planner, const Parameters& values) {
  Candidate best = only_candidate(planner, values);
  bool other_postures = false;
  for (int other = 1; other <= kOtherPostures && planner.in_reach(); ++other) {
    if (miss_of(best) <= kReachTolerance) break;
    if (!planner.go_by_other_posture(other)) continue;
    other_postures = true;
    Candidate candidate = only_candidate(planner, values);
    if (miss_of(candidate) <= kReachTolerance) best = std::move(candidate);
  }
  if (other_postures) planner.go_by_other_posture(0);
  return best;
}

Result<GenerateResult> played_anew(const Problem& problem, const GenerateResult& generation) {
  SHG_TRY_ASSIGN(const std::unique_ptr<Planner> planner, make_planner(problem));
  GenerateResult again = generation;
  again.duration = problem.reach.duration;
  for (Candidate& candidate : again.candidates) {
    candidate = played(*planner, Parameters(candidate.parameters));
  }
  std::stable_sort(again.candidates.begin(), again.candidates.end(), ranks_of(problem.task));
  find_possible_in(problem.task.body, again);
  again.status = status_of(generation.meets_goals(), again.candidates);
  return again;
}

}  // namespace shigusa
