// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/score.hpp>
#include <shigusa/shigusa.hpp>
#include <string>

namespace shigusa::app {

// Score and measures of a recorded motion as a text table.
[[nodiscard]] std::string score_table(const BodyModel& body, const ClipScore& scored);

// The cost of a motion to the body as lines.
[[nodiscard]] std::string cost_lines(const MotionCost& cost);

// Output settings of a result.
struct Delivery {
  std::filesystem::path folder;  // that it is written to
  ExportSettings settings;
  bool json = false;  // prints summary.json in place of the table
};
// Writes a run's result and prints it; returns the exit code.
[[nodiscard]] Result<int> deliver(FinishedRun run, const Delivery& delivery);

}  // namespace shigusa::app
