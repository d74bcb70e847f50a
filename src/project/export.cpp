// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <shigusa/core/names.hpp>
#include <shigusa/io/bvh.hpp>
#include <shigusa/io/csv.hpp>
#include <shigusa/io/file.hpp>
#include <shigusa/io/strip_figure.hpp>
#include <shigusa/kinematics/skeleton_motion.hpp>
#include <shigusa/project/export.hpp>
#include <utility>

#include "robot_columns.hpp"

namespace shigusa {
namespace {

constexpr std::array<std::pair<const char*, ExportFormat>, 5> kFormats{
    {{"bvh", ExportFormat::bvh},
     {"csv", ExportFormat::csv},
     {"svg", ExportFormat::svg},
     {"png", ExportFormat::png},
     {"pdf", ExportFormat::pdf}}};

const char* format_name(ExportFormat format) {
  for (const auto& [name, known] : kFormats) {
    if (known == format) return name;
  }
  return "";
}

void add_point_columns(const std::string& name, const std::vector<Vec3d>& points,
                       std::vector<CsvColumn>& columns) {
  for (int k = 0; k < 3; ++k) {
    CsvColumn column{fmt::format("{}.{} [m]", name, "xyz"[k]), {}};
    for (const Vec3d& point : points) column.values.push_back(point[k]);
    columns.push_back(std::move(column));
  }
}

Result<std::string> motion_csv(const Task& task, const Candidate& candidate) {
  const Motion& motion = candidate.motion;
  std::vector<CsvColumn> columns{{"time [s]", {}}};
  for (int f = 0; f < motion.clip.frames; ++f) {
    columns[0].values.push_back(f * motion.clip.frame_time);
  }
  if (task.body.robot()) {
    add_robot_columns(task.body, motion, columns);
    const auto turned = [](std::vector<Vec3d> points) {
      for (Vec3d& point : points) point = in_robot_world(point);
      return points;
    };
    add_point_columns("centre_of_mass", turned(motion.centre_of_mass), columns);
    for (std::size_t g = 0; g < candidate.goals.size(); ++g) {
      add_point_columns(candidate.goals[g].effector, turned(motion.effectors[g]), columns);
    }
    return format_csv(columns);
  }
  const auto dofs = static_cast<std::size_t>(motion.clip.dofs);
  const auto add = [&](std::size_t d, const char* unit, const std::vector<double>& values) {
    CsvColumn column{fmt::format("{} {}", task.body.dofs()[d].name, unit), {}};
    for (std::size_t i = d; i < values.size(); i += dofs) column.values.push_back(values[i]);
    columns.push_back(std::move(column));
  };
  for (std::size_t d = 0; d < dofs; ++d) add(d, "[rad]", motion.clip.angles);
  for (std::size_t d = 0; d < dofs; ++d) add(d, "torque [N m]", motion.torques);
  add_point_columns("centre_of_mass", motion.centre_of_mass, columns);
  for (std::size_t g = 0; g < candidate.goals.size(); ++g) {
    add_point_columns(candidate.goals[g].effector, motion.effectors[g], columns);
  }
  return format_csv(columns);
}

StripSettings strip_settings(const Task& task) {
  StripSettings settings;
  settings.floor = 0.0;
  settings.facing = Vec3d{0, 0, 1};
  settings.accented.clear();
  for (const Goal& goal : task.goals) {
    settings.accented.push_back(goal.effector == "left_hand" ? Limb::left_arm : Limb::right_arm);
  }
  return settings;
}

Result<std::string> motion_strip(const Task& task, const Candidate& candidate,
                                 FigureFormat format) {
  StripOverlay overlay;
  for (const GoalResult& goal : candidate.goals) overlay.goals.push_back(goal.goal);
  overlay.centre_of_mass = candidate.motion.centre_of_mass;
  overlay.hand_path = candidate.motion.effectors.front();
  return draw_strip(skeleton_motion(task.body, candidate.motion.clip), overlay,
                    strip_settings(task), format);
}

std::string file_name(std::size_t index, const char* format) {
  return fmt::format("candidate-{}.{}", index + 1, format);
}

// Removes what an earlier result left in the folder and this one does not have: more candidates, or
// other formats. Nothing of an older motion may stand beside a new one.
void remove_surplus(const std::filesystem::path& folder, const std::vector<CandidateFiles>& files) {
  constexpr std::size_t kMany = 1000;
  std::error_code ignored;
  for (std::size_t i = 0; i < kMany; ++i) {
    bool any = i < files.size();
    for (const auto& [name, format] : kFormats) {
      if (i < files.size() && files[i].contains(name)) continue;
      any = std::filesystem::remove(folder / file_name(i, name), ignored) || any;
    }
    if (!any) return;
  }
}

}  // namespace

Result<std::vector<ExportFormat>> parse_formats(std::string_view list) {
  std::vector<ExportFormat> formats;
  std::vector<std::string> names;
  for (const auto& [name, format] : kFormats) names.emplace_back(name);
  bool more = !list.empty();
  while (more) {
    const std::size_t comma = list.find(',');
    const std::string_view word = list.substr(0, comma);
    more = comma != list.npos;
    list = more ? list.substr(comma + 1) : std::string_view{};
    bool found = false;
    for (const auto& [name, format] : kFormats) {
      if (word == name) formats.push_back(format);
      found = found || word == name;
    }
    if (!found) return fail(ErrorCode::invalid_argument, unknown_name("format", word, names));
  }
  return formats;
}

Result<void> prepare_folder(const std::filesystem::path& folder) {
  if (folder.empty()) {
    return fail(ErrorCode::invalid_argument, "the folder for the result has an empty name");
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    return fail(ErrorCode::io,
                "cannot make this folder: " + (error ? error.message() : "it is a file"),
                folder.string());
  }
  const std::filesystem::path probe = folder / ".shigusa-probe";
  if (const auto written = write_file(probe, ""); !written) {
    return fail(ErrorCode::io, "cannot write to this folder: " + written.error().message,
                folder.string());
  }
  std::filesystem::remove(probe, error);
  return {};
}

Result<std::string> export_candidate(const Task& task, const Candidate& candidate,
                                     ExportFormat format) {
  switch (format) {
    case ExportFormat::bvh:
      return format_bvh(skeleton_motion(task.body, candidate.motion.clip));
    case ExportFormat::csv:
      return motion_csv(task, candidate);
    case ExportFormat::svg:
      return motion_strip(task, candidate, FigureFormat::svg);
    case ExportFormat::png:
      return motion_strip(task, candidate, FigureFormat::png);
    case ExportFormat::pdf:
      return motion_strip(task, candidate, FigureFormat::pdf);
  }
  return fail(ErrorCode::unsupported, "unknown format");
}

Result<std::string> write_result(const std::filesystem::path& folder, const TaskFile& file,
                                 const Task& task, const Generation& generation,
                                 const RunInfo& info, const std::vector<ExportFormat>& formats) {
  std::vector<CandidateFiles> files(generation.candidates.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const ExportFormat format : formats) {
      const std::string name = file_name(i, format_name(format));
      const Result<std::string> bytes = export_candidate(task, generation.candidates[i], format);
      if (!bytes) return tl::unexpected(bytes.error());
      if (const auto written = write_file(folder / name, *bytes); !written) {
        return tl::unexpected(written.error());
      }
      files[i][format_name(format)] = name;
    }
  }
  remove_surplus(folder, files);
  const std::string summary = format_result(file, task, generation, info, files);
  if (const auto written = write_file(folder / kSummaryName, summary); !written) {
    return tl::unexpected(written.error());
  }
  return summary;
}

}  // namespace shigusa
