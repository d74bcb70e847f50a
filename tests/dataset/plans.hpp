// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <shigusa/dataset.hpp>
#include <string>

#include "dataset/shard_file.hpp"
#include "formats/json_text.hpp"
#include "support/work_folder.hpp"

// Small plans for tests of data sets.
namespace shigusa::testing_support {

// A half body that reaches for points in a box, with searches of few motions.
inline Json small_plan(std::uint64_t tasks, std::uint64_t shard_tasks) {
  return Json::parse(R"({
    "version": 1, "seed": 7, "series": ["angles"],
    "task": {
      "character": {"source": "half_body", "stature_m": {"percentile": [5, 95]}},
      "goals": [{"effector": "right_hand", "position_m": {"box_m": [[-0.4, 0.6, 0.2], [0.1, 1.5, 0.5]]}}],
      "candidates": 2, "evaluations": 120
    }})",
                     nullptr, true, false)
      .patch(Json{{{"op", "add"}, {"path", "/tasks"}, {"value", tasks}},
                  {{"op", "add"}, {"path", "/shard_tasks"}, {"value", shard_tasks}}});
}

inline DatasetPlan plan_of_json(const Json& json, const std::filesystem::path& folder = {}) {
  auto plan = DatasetPlan::parse(json.dump(), "plan.json", folder);
  EXPECT_TRUE(plan) << plan.error().to_string();
  return *std::move(plan);
}

// Makes a plan's data in a folder, which must succeed.
inline DatasetRun made(const DatasetPlan& plan, DatasetSettings settings) {
  const auto run = make_dataset(plan, settings);
  EXPECT_TRUE(run) << run.error().to_string();
  return run.value_or(DatasetRun{});
}

// The tables of a shard, motions first.
struct ShardTables {
  Table tasks;
  Table goals;
  Table missed;
  Table motions;

  ShardTables(const std::filesystem::path& folder, std::uint64_t shard)
      : ShardTables(ShardReader::open(folder / shard_name(shard)).value()) {}

 private:
  explicit ShardTables(const ShardReader& reader)
      : tasks(reader.table("/tasks").value()),
        goals(reader.table("/goals").value()),
        missed(reader.table("/missed").value()) {
    const std::vector<std::string> paths = reader.motion_tables().value();
    if (!paths.empty()) motions = reader.table(paths.front()).value();
  }
};

}  // namespace shigusa::testing_support
