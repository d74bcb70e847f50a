// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/dataset.hpp>
#include <shigusa/error.hpp>
#include <shigusa/explore.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>

namespace shigusa {

/// Format in which the motions of a data set are exported to other programs.
enum class DataFormat {
  npz,        ///< NumPy archives, one per motion
  humanml3d,  ///< HumanML3D's joint positions and sentences
  csv,        ///< one table
  glb,        ///< glTF animations of the skeleton
};

/// Properties of such a format.
struct DataFormatInfo {
  DataFormat format;        ///< the format itself
  std::string_view word;    ///< its word in options
  std::string_view about;   ///< one sentence
  double rate = 0.0;        ///< default frame rate (Hz); 0: the motion's own
  bool rate_fixed = false;  ///< other rates are refused
};

/// All formats, in the order of DataFormat.
inline constexpr std::array kDataFormats{
    DataFormatInfo{.format = DataFormat::npz,
                   .word = "npz",
                   .about = "NumPy archives with the keys of AMASS, on shigusa's own skeleton.",
                   .rate = kUsualRate},
    DataFormatInfo{.format = DataFormat::humanml3d,
                   .word = "humanml3d",
                   .about = "22 joint positions at 20 frames a second with sentences, as HumanML3D "
                            "has them.",
                   .rate = 20.0,
                   .rate_fixed = true},
    DataFormatInfo{.format = DataFormat::csv,
                   .word = "csv",
                   .about = "A table of all numbers, one row a motion; with its series on request.",
                   .rate_fixed = true},
    DataFormatInfo{.format = DataFormat::glb,
                   .word = "glb",
                   .about = "A character's own glTF file with the motion added.",
                   .rate = kUsualRate},
};
/// Words of DataFormat.
template <>
inline constexpr auto kEnumWords<DataFormat> = words_of_table(kDataFormats,
                                                              &DataFormatInfo::format);
/// Table row of a format.
[[nodiscard]] constexpr const DataFormatInfo& info_of(DataFormat format) {
  return kDataFormats[static_cast<std::size_t>(format)];
}

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
  DataFormat format = DataFormat::npz;  ///< format of the files
  bool force = false;                   ///< write into a folder that is not empty
  std::optional<std::string> split{};   ///< "train", "validation" or "test": only people of it
  std::optional<TaskRange> tasks{};     ///< only motions of these
  std::optional<Verdict> verdict{};     ///< only motions of this verdict or a better one
  std::optional<std::uint64_t> most{};  ///< largest number of motions
  std::optional<double> rate{};         ///< Hz, for formats with a selectable rate
  bool series = false;                  ///< csv only: also a file of each motion's series
  /// humanml3d only: shorter motions hold their last pose up to this number of frames; 0: no
  /// padding
  std::size_t least_frames = 0;
  std::filesystem::path character{};  ///< glb only: character to move; empty: the task's own
  std::function<void(const DataExportReport&)> report{};  ///< called regularly
  const std::atomic<bool>* cancel = nullptr;              ///< ends the work once true
};

/// Counts of an export.
struct DataExportRun {
  std::uint64_t motions = 0;   ///< motions written
  std::uint64_t left_out = 0;  ///< motions that the format cannot hold
  std::string why{};           ///< reason for the first of these
  std::uint64_t searched = 0;  ///< glb only: motions searched again for the character
  std::uint64_t missed = 0;    ///< glb only: motions whose goals the character cannot reach
  bool stopped = false;        ///< whether `cancel` ended it early
};

/// Exports motions of a data set to other programs, with a README.md that describes the folder.
/// Shards are read one after the other; each file is whole or absent. The same data gives the same
/// bytes. Fails on a folder that is not empty (unless `force`), on an invalid rate, character or
/// part, on a data set without the data that the format needs, and if no motion can be exported.
[[nodiscard]] Result<DataExportRun> export_dataset(const DataExportSettings& settings);

/// A map of reach as a NumPy archive: `x`, `y`, `z` (m, world), and of each place (x, y, z) its
/// `verdict`, an index into `verdicts` or -1 out of reach, `score`, `strength` (share of the
/// strength of the joint that needs the largest one), `reba`, the worst score by REBA or -1, and
/// `joint`, that joint's index into `joints`.
[[nodiscard]] Result<std::string> map_npz(const BodyModel& body, const ReachMap& map);

}  // namespace shigusa
