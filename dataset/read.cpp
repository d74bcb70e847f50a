// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/dataset_read.hpp>

#include "data_rows.hpp"

namespace shigusa {
namespace {

bool is_number(double x) { return x == x; }

Goal goal_of(const Row& row) {
  Goal goal{.effector = row.text("effector"),
            .position = row.point("position_m"),
            .load = row.number("load_kg"),
            .tolerance = row.point("tolerance_m")};
  if (is_number(row.number("rotation_xyzw"))) {
    const std::vector<double> q = row.numbers("rotation_xyzw");
    goal.rotation = Quatd{q[0], q[1], q[2], q[3]};
  }
  if (is_number(row.number("axis")))
    goal.axis = GoalAxis{row.point("axis"), row.point("direction")};
  return goal;
}

DatasetMotion motion_of(const DataMotion& row) {
  DatasetMotion motion{.task = row.number(),
                       .stature = row.task.number("stature_m"),
                       .mass = row.task.number("mass_kg"),
                       .sex = static_cast<Sex>(row.task.whole("sex")),
                       .rank = static_cast<int>(row.rank()),
                       .score = row.motion.number("score"),
                       .duration = row.motion.number("duration_s"),
                       .verdict = static_cast<Verdict>(row.motion.whole("verdict")),
                       .parameters = row.motion.numbers("parameters")};
  if (const double seat = row.task.number("seat_m"); is_number(seat)) motion.seat = seat;
  for (const Row& goal : row.goals) motion.goals.push_back(goal_of(goal));
  if (const auto* names = row.motion.table->names_of("parameters")) motion.names = *names;
  return motion;
}

}  // namespace

Result<void> read_motions(const std::filesystem::path& folder,
                          const std::function<void(const DatasetMotion&)>& show) {
  SHG_TRY_ASSIGN(const DataFolder data, DataFolder::open(folder));
  for (const std::uint64_t shard : data.shards) {
    SHG_TRY_ASSIGN(const ShardRows rows, read_rows(data, shard));
    for (const DataMotion& row : rows.motions) show(motion_of(row));
  }
  return {};
}

Result<Parameters> named_parameters(const Task& task, std::span<const std::string> names,
                                    std::span<const double> values) {
  SHG_TRY_ASSIGN(const ParameterList list, parameter_list(task.body, task.start, task));
  Parameters parameters = list.start();
  parameters.posed = list.has_posture();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto name = std::find(names.begin(), names.end(), list.all[i].spelled("_rad"));
    const auto k = static_cast<std::size_t>(name - names.begin());
    if (k >= std::min(names.size(), values.size())) continue;
    const bool locked = !is_number(values[k]);
    parameters.locked[i] = locked && list.all[i].kind == ParameterKind::weight;
    if (!locked) parameters.values[i] = values[k];
  }
  return parameters;
}

}  // namespace shigusa
