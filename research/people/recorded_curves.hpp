// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

#include "side_view.hpp"

namespace shigusa::bench {

// A recorded reach at equal shares of its time, or the mean of several.
struct RecordedCurve {
  std::string reach;               // "F: press a button at chest height"
  double duration = 0.0;           // s
  std::vector<double> time{};      // shares of it
  std::vector<double> trunk{};     // deg
  std::vector<double> knee{};      // deg
  std::vector<SidePoint> wrist{};  // from the ankles' middle
};

// All of a table, in its order. Fails on a file that cannot be read, or lacks a column.
[[nodiscard]] Result<std::vector<RecordedCurve>> read_recorded_curves(
    const std::filesystem::path& table);

}  // namespace shigusa::bench
