// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "joint_progress.hpp"
#include "problem/problem.hpp"

namespace shigusa {

// Replays the candidates in a longer duration if the first of them jolts or strains, and does not
// in that duration.
void try_gentler(const Problem& problem, GenerateResult& found);

// Keeps one of the durations in which single candidates would be possible: one in which a new
// search succeeded; none if all failed.
void check_possible_in(const Problem& problem, bool on_all, JointProgress& progress,
                       GenerateResult& found);

}  // namespace shigusa
