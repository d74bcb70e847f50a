// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/generate.hpp>

#include "joint_progress.hpp"
#include "problem/task_search.hpp"

namespace shigusa {

// A further search of a problem whose first search found no possible motion, too few, or a rise
// that strains.
struct Attempt {
  RunSettings run{};
  std::optional<double> duration{};  // s; none: the problem's own
  bool plays = false;                // replays the candidates found so far instead of searching
  bool on_all = false;               // see search_problem
};

// The next attempt at a problem; none where it does not apply to the result so far.
using NextAttempt = std::optional<Attempt>(const Problem& problem, const GenerateResult& found);
// A longer duration, for motions that are impossible only because they are too fast.
[[nodiscard]] NextAttempt slower_attempt;
// All approaches, where the first was searched alone and from no motions given.
[[nodiscard]] NextAttempt other_approaches_attempt;
// A larger number of motions.
[[nodiscard]] NextAttempt longer_attempt;
// Other random numbers.
[[nodiscard]] NextAttempt other_numbers_attempt;
// A longer duration, for a person who stands up and strains, where other candidates are too fast.
[[nodiscard]] NextAttempt slower_rise_attempt;
// All attempts, in the order in which they are made.
inline constexpr NextAttempt* kAttempts[] = {slower_attempt, other_approaches_attempt,
                                             longer_attempt, other_numbers_attempt,
                                             slower_rise_attempt};

// The result of one attempt; replays are not counted as evaluations. Fails as search_problem does,
// and for a duration out of range.
[[nodiscard]] Result<GenerateResult> made(const Attempt& attempt, const Problem& problem,
                                          const GenerateResult& found, JointProgress& progress);

// The better of two results, with the evaluations of both.
[[nodiscard]] GenerateResult better_of(const Task& task, GenerateResult found,
                                       GenerateResult other);

// Whether an uncancelled search reached the goals without a possible motion.
[[nodiscard]] bool wants_more(const GenerateResult& generation);

// The shortest duration (s) in which some candidate that is now too fast becomes possible.
[[nodiscard]] std::optional<double> possible_duration(const GenerateResult& generation);

}  // namespace shigusa
