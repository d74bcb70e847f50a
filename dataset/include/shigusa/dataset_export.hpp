// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <shigusa/dataset.hpp>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>

namespace shigusa {

/// Progress of an export.
struct DataExportReport {
  std::uint64_t tasks = 0;    ///< tasks of the data set examined
  std::uint64_t of = 0;       ///< tasks to examine
  std::uint64_t motions = 0;  ///< motions written
};

/// Selection of motions to export, with settings.
struct DataExportSettings {
  std::filesystem::path from;           ///< folder of the data set
  std::filesystem::path to;             ///< folder for the files
  bool force = false;                   ///< write into a folder that is not empty
  std::optional<std::string> split{};   ///< "train", "validation" or "test": only people of it
  std::optional<TaskRange> tasks{};     ///< only motions of these
  std::optional<Verdict> verdict{};     ///< only motions of this verdict or a better one
  std::optional<std::uint64_t> most{};  ///< largest number of motions
  double rate = kUsualRate;             ///< frames per second (Hz)
  std::filesystem::path character{};    ///< character to move; empty: the task's own
  std::function<void(const DataExportReport&)> report{};  ///< called regularly
  const std::atomic<bool>* cancel = nullptr;              ///< ends the work once true
};

/// Counts of an export.
struct DataExportRun {
  std::uint64_t motions = 0;   ///< motions written
  std::uint64_t left_out = 0;  ///< motions that cannot be made for the character
  std::string why{};           ///< reason for the first of these
  std::uint64_t searched = 0;  ///< motions searched again for the character
  std::uint64_t missed = 0;    ///< motions whose goals the character cannot reach
  bool stopped = false;        ///< whether `cancel` ended it early
};

/// Exports motions of a data set as GLB files, a character's own glTF file with the motion added,
/// and a README.md that describes the folder. Other formats are exported in Python, by
/// `shigusa.dataset`.
/// Shards are read one after the other; each file is whole or absent. The same data gives the same
/// bytes. Fails on a folder that is not empty (unless `force`), on an invalid rate, character or
/// part, on a data set without the data that the format needs, and if no motion can be exported.
[[nodiscard]] Result<DataExportRun> export_dataset(const DataExportSettings& settings);

}  // namespace shigusa
