// SPDX-License-Identifier: MIT
#include "attempt.hpp"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "candidate.hpp"
#include "problem_search.hpp"

namespace shigusa {
namespace {

// Rank of a result: a possible first candidate, the number of feasible candidates up to the number
// shown, a low first score.
std::tuple<bool, int, double> choice_of(const Task& task, const GenerateResult& generation) {
  const auto could =
      std::count_if(generation.candidates.begin(), generation.candidates.end(), could_be_made);
  const bool first = generation.candidates.front().judgement.verdict == Verdict::possible;
  return {first, std::min(static_cast<int>(could), shown_least(task)),
          -generation.candidates.front().score.total};
}

constexpr int kLeastChoice = 3;  // candidates

// Fewer that look different are no choice.
bool lacks_choice(const Task& task, const GenerateResult& generation) {
  const auto [first, could, score] = choice_of(task, generation);
  return !first || could < std::min(kLeastChoice, task.candidates);
}

// Factor on the usual number of motions, for a task that does not set a number.
constexpr int kLongerSearch = 3;

constexpr std::uint64_t kOtherNumbers = 0x9e3779b97f4a7c15U;

// In the least duration in which a candidate is possible; replays the candidates if the task's
// budget is used up.
std::optional<Attempt> slower(const Problem& problem, const GenerateResult& found) {
  const std::optional<double> duration = possible_duration(found);
  if (problem.task.duration || !duration) return std::nullopt;
  return Attempt{run_of(problem), duration, problem.task.evaluations.has_value()};
}

}  // namespace

std::optional<Attempt> slower_attempt(const Problem& problem, const GenerateResult& found) {
  return wants_more(found) ? slower(problem, found) : std::nullopt;
}

std::optional<Attempt> other_approaches_attempt(const Problem& problem,
                                                const GenerateResult& found) {
  const bool lanes = problem.task.generator == MotionGenerator::weighted_ik;
  const bool alone = wants_one(problem.task) && problem.task.starts.empty();
  if (!alone || !lanes || !wants_more(found)) return std::nullopt;
  return Attempt{.run = run_of(problem), .on_all = true};
}

std::optional<Attempt> longer_attempt(const Problem& problem, const GenerateResult& found) {
  const Task& task = problem.task;
  if (task.evaluations || found.end == SearchEnd::cancelled || task.pareto) return std::nullopt;
  const bool chooses = found.status == ReachStatus::reached && !traits_of(task.preset).layers;
  if (!wants_more(found) && !(chooses && lacks_choice(task, found))) return std::nullopt;
  Attempt attempt{run_of(problem)};
  attempt.run.evaluations = kLongerSearch * usual_evaluations(task);
  return attempt;
}

// Repeats the search with as many motions as the longer one.
std::optional<Attempt> other_numbers_attempt(const Problem& problem, const GenerateResult& found) {
  const Task& task = problem.task;
  if (task.evaluations || task.pareto || task.own_search || !wants_more(found)) return std::nullopt;
  Attempt attempt{run_of(problem)};
  attempt.run.seed ^= kOtherNumbers;
  attempt.run.evaluations = kLongerSearch * usual_evaluations(task);
  return attempt;
}

std::optional<Attempt> slower_rise_attempt(const Problem& problem, const GenerateResult& found) {
  const bool strains = found.candidates.front().judgement.verdict == Verdict::strains;
  const bool ended = found.slowed || found.end == SearchEnd::cancelled;
  return strains && !ended && !problem.reach.rise.empty() ? slower(problem, found) : std::nullopt;
}

Result<GenerateResult> made(const Attempt& attempt, const Problem& problem,
                            const GenerateResult& found, JointProgress& progress) {
  std::unique_ptr<const Problem> other;
  if (attempt.duration) {
    SHG_TRY_ASSIGN(other, with_duration(problem, *attempt.duration));
  }
  const Problem& posed = other ? *other : problem;
  if (!attempt.plays) {
    return search_problem(posed, attempt.run, progress.part(1.0), attempt.on_all);
  }
  SHG_TRY_ASSIGN(GenerateResult again, played_anew(posed, found));
  again.log.evaluations = 0;
  return again;
}

GenerateResult better_of(const Task& task, GenerateResult found, GenerateResult other) {
  const bool better = wants_more(found) || choice_of(task, found) < choice_of(task, other);
  const int evaluations = found.log.evaluations + other.log.evaluations;
  const bool taken = better && other.status == ReachStatus::reached;
  if (better) found.end = other.end;
  GenerateResult& best = taken ? other : found;
  best.log.evaluations = evaluations;
  return std::move(best);
}

bool wants_more(const GenerateResult& generation) {
  return generation.status == ReachStatus::unsteady && generation.end != SearchEnd::cancelled;
}

std::optional<double> possible_duration(const GenerateResult& generation) {
  std::optional<double> least;
  for (const Candidate& candidate : generation.candidates) {
    const std::optional<double>& own = candidate.judgement.possible_in;
    if (own && (!least || *own < *least)) least = own;
  }
  return least;
}

}  // namespace shigusa
