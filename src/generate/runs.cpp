// SPDX-License-Identifier: MIT
#include "runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "candidate.hpp"

namespace shigusa {

bool runs_again(const Task& task, const GenerateResult& generation) {
  if (task.preset != Preset::paper || task.evaluations || task.own_search) return false;
  if (task.search.value_or(SearchMethod::paper_ga) != SearchMethod::paper_ga) return false;
  if (generation.end == SearchEnd::cancelled || generation.runs >= task.most_runs) return false;
  return static_cast<int>(generation.candidates.size()) < min(kPaperCandidates, task.candidates);
}

void add_run(const Task& task, GenerateResult run, GenerateResult& generation) {
  ++generation.runs;
  generation.evaluations += run.evaluations;
  generation.generations += run.generations;
  generation.rejected_nan += run.rejected_nan;
  generation.near_copies += run.near_copies;
  generation.missed += run.missed;
  generation.replay_differs += run.replay_differs;
  generation.replay_difference = max(generation.replay_difference, run.replay_difference);
  generation.end = run.end;
  if (run.best_seen_score < generation.best_seen_score) {
    generation.best_seen = std::move(run.best_seen);
    generation.best_seen_score = run.best_seen_score;
  }
  std::vector<Candidate>& all = generation.candidates;
  for (Candidate& candidate : run.candidates) {
    const bool is_copy = std::any_of(all.begin(), all.end(), [&candidate](const Candidate& other) {
      return largest_distance(other.motion.clip, candidate.motion.clip) < kDistinctPosture;
    });
    if (is_copy) {
      ++generation.near_copies;
    } else {
      all.push_back(std::move(candidate));
    }
  }
  std::stable_sort(all.begin(), all.end(), ranks_before);
  const auto most = static_cast<std::size_t>(task.candidates);
  if (all.size() > most) all.erase(all.begin() + task.candidates, all.end());
  generation.fewer.clear();
  if (all.size() == most) return;
  generation.fewer =
      fmt::format("{} of {} candidates: {} runs with other random numbers each ended in no others",
                  all.size(), task.candidates, generation.runs);
}

}  // namespace shigusa
