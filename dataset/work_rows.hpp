// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <string>
#include <vector>

#include "table.hpp"

namespace shigusa {

// Names of a task's actions, "1 grasp box", and of its things.
[[nodiscard]] std::vector<std::string> action_names(const Request& task);
[[nodiscard]] std::vector<std::string> thing_names(const Request& task);

// A candidate of a piece of work with `frames` frames at equal times.
[[nodiscard]] Candidate in_frames(const Candidate& candidate, std::size_t frames);

// A series of `width` numbers a frame with `frames` frames at equal times.
[[nodiscard]] std::vector<double> numbers_in_frames(const std::vector<double>& series,
                                                    std::size_t width, std::size_t frames);

// Adds what a piece of work has beside a motion to its row.
void add_work(const Request& task, const Candidate& candidate, Table& table);

// Adds the series of the actions, and of the things, of a candidate of in_frames.
void add_present_actions(const Candidate& candidate, Column& into);
void add_poses(const Candidate& candidate, Column& into);

}  // namespace shigusa
