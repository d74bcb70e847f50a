// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

namespace shigusa::bench {

// The figures of one reach: changes from its start to its end, and its wrist's path.
struct ReachFigures {
  double trunk = 0.0;  // rad, forwards
  double knee = 0.0;   // rad, of flexion
  double drop = 0.0;   // m, of the pelvis
  double back = 0.0;   // m, of the pelvis
  double bow = 0.0;    // forwards, over the distance
  double peak = 0.0;   // when the wrist is fastest, as a share of the time
};

// A reach of a person who stands with arms hanging at its start.
struct RecordedReach {
  std::string person;     // "boxS1"
  bool both = false;      // hands
  double duration = 0.0;  // s
  double from = 0.0;      // m, height of the wrist at the start
  double height = 0.0;    // m, height of the wrist at the end
  double ahead = 0.0;     // m, at the end
  ReachFigures figures;
};

// All such reaches of a table, in its order. Fails on a file that cannot be read, or lacks a
// column.
[[nodiscard]] Result<std::vector<RecordedReach>> read_recorded_reaches(
    const std::filesystem::path& table);

}  // namespace shigusa::bench
