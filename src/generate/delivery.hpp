// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "planner.hpp"

namespace shigusa {

// Makes candidates of the points found by a search on one approach, and states why there are fewer
// than the task asks for:
//   1. Each picked point is played on the first approach that leads to the goals, and becomes a
//      candidate unless it copies one, until there are enough.
//   2. Where all motions of a style collide, spare points of that style are tried.
//   3. Spare points with scores little worse than the best fill the gaps.
//   4. Motions that exceed a limit or collide are dropped if others do not, then the worst of any
//      excess.
// The task's preset selects the steps.
void deliver_candidates(const Task& task, Planner& planner, std::size_t approach, Found found,
                        GenerateResult& generation);

// Whether the criteria of a task penalise jolts.
[[nodiscard]] bool minds_jolts(const Task& task);
// Drops and counts the candidates that jolt, if some possible candidate does not.
void drop_jolts(GenerateResult& generation);

}  // namespace shigusa
