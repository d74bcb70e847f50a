// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "export_file.hpp"
#include "io/csv.hpp"
#include "robot_columns.hpp"

namespace shigusa {
namespace {

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
      add_point_columns(candidate.goals[g].asked.effector, turned(motion.effectors[g]), columns);
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
    add_point_columns(candidate.goals[g].asked.effector, motion.effectors[g], columns);
  }
  return format_csv(columns);
}

}  // namespace

template <>
Result<MadeFile> write_as<FileFormat::csv>(const WriteRequest& request) {
  return unread(motion_csv(request.task, request.candidate));
}

}  // namespace shigusa
