// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "planner.hpp"

namespace shigusa {

// Makes candidates of what a search on one approach came upon, and tells why there are fewer than
// asked for:
//  1. Each picked motion is played on the first approach that leads to the goals, and becomes a
//     candidate unless it is a copy of one, until there are enough.
//  2. Motions that were a copy by kDistinctEnd are taken where they differ by kNearEnd.
//  3. Where no motion of a style is free of collisions, a spare one of that style is tried.
//  4. Spare motions that score little worse than the best fill up what is lacking, first those that
//     end kDistinctEnd from all others, then those that end kNearEnd from them.
//  5. Motions that pass a limit or a body go where others do not, then the worst of too many.
// The task's preset says which of these steps there are.
void deliver_candidates(const Task& task, Planner& planner, std::size_t approach, Found found,
                        GenerateResult& generation);

// Whether a task's motions are not to jolt: by criteria that give jolts a weight.
[[nodiscard]] bool minds_jolts(const Task& task);
// Where some possible candidate does not jolt, those that do are left out, and counted.
void drop_jolts(GenerateResult& generation);

}  // namespace shigusa
