// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "problem/problem.hpp"
#include "rollout/reach_problem.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// A motion with all facts about it.
[[nodiscard]] Candidate make_candidate(const Problem& problem, const ReachProblem& approach,
                                       const Parameters& parameters, RolledOut rolled);

// Distance that is left to the goals (m), the root of the summed squares.
[[nodiscard]] double miss_of(const Candidate& candidate);

// The status of a search, by whether its candidates meet their goals (`met`) and are possible.
[[nodiscard]] ReachStatus status_of(bool met, std::span<const Candidate> candidates);

// Whether somebody could make a candidate, and be it by straining.
[[nodiscard]] bool could_be_made(const Candidate& candidate);

// The number of motions that people see whatever they score: kShownLeast, or as many as are asked
// for.
[[nodiscard]] int shown_least(const Task& task);

// Whether a candidate passes through the body, an obstacle or the floor by what counts.
[[nodiscard]] bool collides(const Candidate& candidate);

// Orders candidates: what is impossible after all that is not, where it asks for motions which pass
// through nothing those that do after all others, and of each the lowest score first, a NaN last.
struct RanksBefore {
  bool asks_free = false;

  [[nodiscard]] bool operator()(const Candidate& a, const Candidate& b) const;
};
[[nodiscard]] RanksBefore ranks_of(const Task& task);

// Largest root-mean-square difference of two motions' joint angles over their frames (rad).
[[nodiscard]] double largest_distance(const Clip& a, const Clip& b);
// Root-mean-square difference of the joint angles of their last frames (rad).
[[nodiscard]] double final_distance(const Clip& a, const Clip& b);

// Adds a search's counts to the result's.
void add_counts(const SearchResult& found, GenerateResult& generation);

}  // namespace shigusa
