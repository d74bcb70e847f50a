// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/character.hpp>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// Series of numbers of a candidate, frame by frame. The numbers are those of the C interface.
enum class MotionSeries {
  time,               ///< s
  angles,             ///< rad, of each degree of freedom
  torques,            ///< N·m, of each degree of freedom
  centre_of_mass,     ///< m, world
  support,            ///< m inside the support polygon, see SupportFrame; none without feet
  effectors,          ///< m, world, of each goal's effector
  node_translations,  ///< of each node in its parent, in units of node_unit
  node_rotations,     ///< of each node in its parent
  upper_limits,       ///< rad, of each degree of freedom in that posture
  things,             ///< m and quaternions from the world's axes, of each thing's middle
};
/// The words of MotionSeries.
template <>
inline constexpr std::array kEnumWords<MotionSeries>{
    EnumWord{MotionSeries::time, "time"},
    EnumWord{MotionSeries::angles, "angles"},
    EnumWord{MotionSeries::torques, "torques"},
    EnumWord{MotionSeries::centre_of_mass, "centre_of_mass"},
    EnumWord{MotionSeries::support, "support"},
    EnumWord{MotionSeries::effectors, "effectors"},
    EnumWord{MotionSeries::node_translations, "node_translations"},
    EnumWord{MotionSeries::node_rotations, "node_rotations"},
    EnumWord{MotionSeries::upper_limits, "upper_limits"},
    EnumWord{MotionSeries::things, "things"}};

/// Frames and place of a series.
struct SeriesSettings {
  /// Hz, kRateMin to kRateMax: frames as in files (motion_at); empty: the motion's own frames.
  std::optional<double> rate{};
  MotionPlace place = MotionPlace::world;  ///< where nodes move
};
/// Parses settings from JSON: {"fps": 24, "place": "file"}, of which each may be absent.
[[nodiscard]] Result<SeriesSettings> parse_series_settings(std::string_view text,
                                                           std::string_view name);

/// A series with the meaning of its columns.
struct SeriesTable {
  std::size_t frames = 0;                 ///< number of frames
  double frame_time = 0.0;                ///< s, between frames
  std::vector<std::string> names{};       ///< joints, nodes, effectors, things or two margins
  std::vector<std::string> components{};  ///< "x", "y", "z", "qx", …; empty: one number each
  std::vector<double> values{};           ///< (frames × names × components); empty lists count 1
};
/// A series of a candidate. At a rate, torques, the centre of mass and the support lie on lines
/// between the motion's own frames; all others are those of the posture there. Fails on a rate
/// outside its range.
[[nodiscard]] Result<SeriesTable> motion_series(const CharacterSpec& character, const Task& task,
                                                const Candidate& candidate, MotionSeries series,
                                                const SeriesSettings& settings = {});
/// The meaning of a series as JSON: {"name", "unit" ("" for quaternions and units of files),
/// "fps", "shape" (of the table), "names" and "components" (of its columns; absent without)}.
[[nodiscard]] std::string format_series(MotionSeries series, const SeriesTable& table);

}  // namespace shigusa
