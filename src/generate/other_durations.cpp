// SPDX-License-Identifier: MIT
#include "other_durations.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "attempt.hpp"
#include "core/say.hpp"
#include "delivery.hpp"
#include "problem_search.hpp"

namespace shigusa {
namespace {

bool first_jolts(const GenerateResult& generation) {
  return generation.candidates.front().measures.sudden.jolts();
}

bool first_strains(const GenerateResult& generation) {
  return generation.candidates.front().judgement.verdict == Verdict::strains;
}

// Factors on the duration, tried in order while the first candidate jolts or strains and the task
// sets no duration; for a strain only up to kCalmest.
constexpr std::array kGentler{1.15, 1.3, 1.5, 1.75};
constexpr double kCalmest = 1.3;

// Resolution (s) of a reported duration, and the number of durations tried.
constexpr double kToldStep = 0.1;
constexpr int kToldTries = 4;

Result<GenerateResult> played_in(double duration, const Problem& problem,
                                 const GenerateResult& generation) {
  SHG_TRY_ASSIGN(const auto other, with_duration(problem, duration));
  return played_anew(*other, generation);
}

}  // namespace

void try_gentler(const Problem& problem, GenerateResult& found) {
  const Task& task = problem.task;
  if (!found.meets_goals() || task.duration || found.end == SearchEnd::cancelled) return;
  const GenerateResult in_haste = found;
  for (const double factor : kGentler) {
    const bool jolting = first_jolts(found);
    if (!jolting && !(first_strains(found) && factor <= kCalmest)) return;
    Result<GenerateResult> again = played_in(factor * in_haste.duration, problem, in_haste);
    if (!again || first_jolts(*again) || again->status != found.status) continue;
    if (!jolting && first_strains(*again)) continue;
    found = std::move(*again);
    drop_jolts(found);
    const auto left = static_cast<int>(found.candidates.size());
    if (found.fewer.empty() && left < task.candidates) {
      found.fewer = say("fewer_jolts", left, task.candidates, found.log.jolting);
    }
    found.gentled = true;
  }
}

void check_possible_in(const Problem& problem, bool on_all, JointProgress& progress,
                       GenerateResult& found) {
  const std::optional<double> least = possible_duration(found);
  if (!wants_more(found) || !least) return;
  // a budget set by the task is used up
  const bool plays = problem.task.evaluations.has_value();
  std::optional<double> told;
  double tenths = std::ceil(*least / kToldStep);
  for (int k = 0; k < kToldTries && !told; ++k, tenths = std::ceil(1.2 * tenths)) {
    const double duration = kToldStep * tenths;
    if (duration > kSlowest * found.duration) break;
    const Result<GenerateResult> again =
        made({run_of(problem), duration, plays, on_all}, problem, found, progress);
    if (again && again->status == ReachStatus::reached) told = duration;
  }
  for (Candidate& candidate : found.candidates) {
    std::optional<double>& own = candidate.judgement.possible_in;
    if (own) own = told;
  }
}

}  // namespace shigusa
