// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

namespace shigusa {

// Distinct candidates that the paper has a person choose from (section 4.1).
inline constexpr int kPaperCandidates = 3;

// Whether the search of a task begins again with other random numbers: of the preset paper, of
// whose genetic algorithm one run often ends with all genomes alike, where the task does not say
// how many motions are scored; until there are kPaperCandidates candidates, or as many as the task
// asks for, or Task::most_runs are done.
[[nodiscard]] bool runs_again(const Task& task, const GenerateResult& generation);

// Takes another run's candidates in, but for those that move as one that is there does.
void add_run(const Task& task, GenerateResult run, GenerateResult& generation);

}  // namespace shigusa
