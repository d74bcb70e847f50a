// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/score.hpp>
#include <shigusa/shigusa.hpp>
#include <string>

namespace shigusa::app {

// The score and the measures of a recorded motion as a table for a person.
[[nodiscard]] std::string score_table(const BodyModel& body, const ClipScore& scored);

// How a result goes to the user.
struct Delivery {
  std::filesystem::path folder;  // that it is written to
  ExportSettings settings;
  bool json = false;  // prints summary.json in place of the table
};
// Writes a run's result and prints it; gives the exit code.
[[nodiscard]] Result<int> deliver(const FinishedRun& run, const Delivery& delivery);

}  // namespace shigusa::app
