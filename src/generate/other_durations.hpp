// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "joint_progress.hpp"
#include "problem/problem.hpp"

namespace shigusa {

// Takes the candidates in a longer duration where the first of them jolts or strains in the usual
// one, and not in that.
void try_gentler(const Problem& problem, GenerateResult& found);

// Leaves of all times in which single candidates would be possible one in which the task was
// searched again and something is; none where nothing was.
void check_possible_in(const Problem& problem, bool on_all, JointProgress& progress,
                       GenerateResult& found);

}  // namespace shigusa
