// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "problem/problem.hpp"
#include "rollout/reach_problem.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// The shortest duration (s), up to kSlowest times its own, in which a motion judged impossible is
// possible, else in which it strains; none if it is impossible in all of them.
[[nodiscard]] std::optional<double> possible_in(const Judgement& judgement, const BodyModel& body,
                                                const Motion& motion,
                                                const MotionMeasures& measures);

// A candidate of a motion, with all its measures but possible_in.
[[nodiscard]] Candidate make_candidate(const Problem& problem, const ReachProblem& approach,
                                       const Parameters& parameters, RolledOut rolled);

// Remaining distance to the goals (m), the root of the summed squares.
[[nodiscard]] double miss_of(const Candidate& candidate);

// The status of a search, by whether its candidates meet their goals (`met`) and are possible.
[[nodiscard]] ReachStatus status_of(bool met, std::span<const Candidate> candidates);

// Whether a candidate is feasible, straining included.
[[nodiscard]] bool could_be_made(const Candidate& candidate);

// Number of candidates shown whatever their score: kShownLeast, or fewer if the task asks for
// fewer.
[[nodiscard]] int shown_least(const Task& task);

// Whether a task asks for one motion, in any time: then it is slowed down where others would be
// looked for.
[[nodiscard]] bool wants_one(const Task& task);

// Whether a candidate penetrates the body, an obstacle or the floor beyond the tolerance.
[[nodiscard]] bool collides(const Candidate& candidate);

// Order of candidates: impossible ones last; with `asks_free`, colliding ones after free ones; then
// by ascending score, a NaN last.
struct RanksBefore {
  bool asks_free = false;

  [[nodiscard]] bool operator()(const Candidate& a, const Candidate& b) const;
};
[[nodiscard]] RanksBefore ranks_of(const Task& task);

// Largest per-frame root-mean-square difference of two motions' joint angles (rad).
[[nodiscard]] double largest_distance(const Clip& a, const Clip& b);
// Root-mean-square difference of the joint angles in the last frames (rad).
[[nodiscard]] double final_distance(const Clip& a, const Clip& b);

// Adds a search's counts to the result's.
void add_counts(const SearchResult& found, GenerateResult& generation);

}  // namespace shigusa
