// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace shigusa::app {

// Accepts whole numbers in a range; CLI11's own conversion takes -1 for the largest unsigned one.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);

// Accepts a frame, from 0, or "rest", which becomes kRestPose.
[[nodiscard]] CLI::Validator frame_or_rest();

// Says what is wrong with the call, with the nearest name for one that is not known, and returns
// the exit code.
int report_usage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace shigusa::app
