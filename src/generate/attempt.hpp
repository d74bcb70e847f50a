// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/generate.hpp>

#include "joint_progress.hpp"
#include "problem/task_search.hpp"

namespace shigusa {

// A further search of a problem whose first one found nothing possible, or no choice.
struct Attempt {
  RunSettings run{};
  std::optional<double> duration{};  // s; none: the problem's
  bool plays = false;                // plays the candidates that were found, and searches nothing
  bool on_all = false;               // as search_problem has it
};

// An attempt at a problem; none where it does not apply to what was found by then.
using NextAttempt = std::optional<Attempt>(const Problem& problem, const GenerateResult& found);
// In a longer duration, where motions are impossible only for their haste.
[[nodiscard]] NextAttempt slower_attempt;
// With more motions.
[[nodiscard]] NextAttempt longer_attempt;
// With other random numbers.
[[nodiscard]] NextAttempt other_numbers_attempt;
// The attempts, in the order in which they are made.
inline constexpr NextAttempt* kAttempts[] = {slower_attempt, longer_attempt, other_numbers_attempt};

// The result of an attempt by itself; motions that it plays alone are not counted. Fails as
// search_problem does, and where the duration is out of range.
[[nodiscard]] Result<GenerateResult> made(const Attempt& attempt, const Problem& problem,
                                          const GenerateResult& found, JointProgress& progress);

// The better of what was found and what an attempt found, which counts the motions of both.
[[nodiscard]] GenerateResult better_of(const Task& task, GenerateResult found,
                                       GenerateResult other);

// Whether a search that was not cancelled found motions to the goals, of which none is possible.
[[nodiscard]] bool wants_more(const GenerateResult& generation);

// The least duration (s) in which a candidate is possible that is not so only for its haste.
[[nodiscard]] std::optional<double> possible_duration(const GenerateResult& generation);

}  // namespace shigusa
