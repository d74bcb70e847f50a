// SPDX-License-Identifier: MIT
// Data sets of pieces of work: actions and things are drawn, and kept with the whole motion.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <shigusa/dataset_export.hpp>
#include <shigusa/score.hpp>

#include "dataset/plans.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::size_t kFrames = 241;
constexpr std::size_t kPose = 7;

// A cup of any mass is taken from any place and put elsewhere.
Json cup_plan() {
  return Json::parse(R"({
    "version": 1, "seed": 5, "tasks": 2, "shard_tasks": 2,
    "task": {
      "version": 2, "candidates": 1, "evaluations": 64,
      "things": {"cup": {"shape": "cylinder", "size_m": [0.08, {"uniform": [0.08, 0.14]}, 0.08],
                         "mass_kg": {"uniform": [0.2, 1]},
                         "position_m": {"box_m": [[-0.4, 0.9, 0.3], [-0.2, 1.1, 0.4]]}}},
      "actions": [{"grasp": "cup"}, {"wait_s": {"uniform": [0.1, 0.3]}},
                  {"place": "cup", "position_m": {"box_m": [[-0.2, 1.0, 0.35], [0, 1.2, 0.45]]},
                   "turn_deg": {"choice": [0, 10]}}]
    }})");
}

TEST(DatasetOfWork, DrawsActionsAndThings) {
  const DatasetPlan plan = plan_of_json(cup_plan());
  const TaskFile first = plan.task(0).value().file;
  const TaskFile second = plan.task(1).value().file;
  ASSERT_EQ(first.actions.size(), 3U);
  EXPECT_NE(first.things[0].mass, second.things[0].mass);
  EXPECT_NE(first.things[0].position, second.things[0].position);
  EXPECT_NE(first.actions[1].wait, second.actions[1].wait);
  EXPECT_NE(first.actions[2].position, second.actions[2].position);
  EXPECT_GE(first.things[0].size.y, 0.08);
  EXPECT_LE(first.things[0].size.y, 0.14);
}

TEST(DatasetOfWork, KeepsTheWholePiece) {
  const DatasetPlan plan = plan_of_json(cup_plan());
  const WorkFolder work;
  made(plan, {.folder = work.path(), .threads = 1});
  ShardTables shard(work.path(), 0);
  ASSERT_EQ(shard.motions.rows(), 2U);
  EXPECT_THAT(*shard.motions.names_of("actions"),
              ElementsAre("1 grasp cup", "2 wait_s", "3 place cup"));
  EXPECT_THAT(*shard.motions.names_of("things"), ElementsAre("cup"));
  const std::size_t joints = shard.motions.names_of("joints")->size();
  EXPECT_THAT(shard.motions["angles"].shape, ElementsAre(kFrames, joints));
  const auto starts = shard.motions["action_start_s"].as<double>();
  const auto ends = shard.motions["action_end_s"].as<double>();
  const auto durations = shard.motions["duration_s"].as<double>();
  const auto present = shard.motions["actions"].as<std::uint8_t>();
  const auto poses = shard.motions["things"].as<float>();
  const auto masses = shard.motions["thing_mass_kg"].as<double>();
  ASSERT_EQ(poses.size(), 2 * kFrames * kPose);
  for (std::size_t row = 0; row < 2; ++row) {
    const TaskFile file = plan.task(row).value().file;
    EXPECT_EQ(masses[row], file.things[0].mass);
    EXPECT_EQ(starts[3 * row], 0.0);
    EXPECT_EQ(ends[3 * row + 1], starts[3 * row + 2]);
    EXPECT_NEAR(ends[3 * row + 1] - starts[3 * row + 1], *file.actions[1].wait, 1.0 / 60.0);
    EXPECT_EQ(ends[3 * row + 2], durations[row]);
    for (std::size_t f = 0; f < kFrames; ++f) {
      const double time = durations[row] * static_cast<double>(f) / (kFrames - 1);
      const std::size_t action = present[row * kFrames + f];
      ASSERT_LT(action, 3U);
      EXPECT_LE(starts[3 * row + action], time + 1e-9);
      EXPECT_GE(ends[3 * row + action], time - 1e-9);
    }
    const float* const pose = poses.data() + row * kFrames * kPose;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(pose[k], file.things[0].position[k], 1e-6);
      EXPECT_NEAR(pose[(kFrames - 1) * kPose + static_cast<std::size_t>(k)],
                  (*file.actions[2].position)[k], 1e-3);
    }
  }
}

TEST(DatasetOfWork, GoalsOfAnActionStandBesideEachOther) {
  Json json = cup_plan();
  json["task"].erase("things");
  json["task"]["actions"] = Json::parse(R"([{"goals": [
    {"effector": "right_hand", "position_m": {"box_m": [[-0.4, 0.9, 0.3], [-0.2, 1.1, 0.4]]}},
    {"effector": "left_hand", "position_m": {"beside": {"goal": 0, "offset_m": [0.4, 0, 0]}}}]}])");
  const TaskFile file = plan_of_json(json).task(0).value().file;
  const std::vector<Goal>& goals = file.actions.at(0).goals;
  EXPECT_NEAR(goals[1].position.x - goals[0].position.x, 0.4, 1e-12);
}

// The floor bears the cup in the hand too.
TEST(DatasetOfWork, KeepsThePressureOfTheWholePiece) {
  Json json = cup_plan();
  json["tasks"] = 1;
  json["task"]["things"]["cup"]["mass_kg"] = 4;
  json["series"] = {"angles", "pressure"};
  const DatasetPlan plan = plan_of_json(json);
  const WorkFolder work;
  made(plan, {.folder = work.path(), .threads = 1});
  ShardTables shard(work.path(), 0);
  const auto pressure = shard.motions["pressure"].as<float>();
  ASSERT_EQ(pressure.size(), 2 * kFrames);
  TaskFile file = plan.task(0).value().file;
  Task task = make_task(file, {}).value();
  const Candidate whole = perform(task).value().candidates.front();
  const std::vector<Vec3d> own = centres_of_pressure(task, whole);
  EXPECT_NEAR(pressure[0], own.front().x, 1e-6);
  EXPECT_NEAR(pressure[1], own.front().z, 1e-6);
  EXPECT_NEAR(pressure[2 * kFrames - 2], own.back().x, 1e-6);
  EXPECT_NEAR(pressure[2 * kFrames - 1], own.back().z, 1e-6);
  const auto middle = static_cast<double>(own.size() - 1) / 2.0;
  const Vec3d before = own[static_cast<std::size_t>(middle)];
  const Vec3d after = own[static_cast<std::size_t>(middle + 0.5)];
  EXPECT_NEAR(pressure[kFrames - 1], 0.5 * (before.x + after.x), 1e-6);
  EXPECT_NEAR(pressure[kFrames], 0.5 * (before.z + after.z), 1e-6);
}

// Number of the file's nodes of that name.
std::ptrdiff_t nodes_named(const std::string& glb, const std::string& name) {
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, sizeof size);
  const Json json = Json::parse(glb.substr(20, size));
  return std::count_if(json["nodes"].begin(), json["nodes"].end(),
                       [&](const Json& node) { return node.value("name", "") == name; });
}

TEST(DatasetOfWork, LeavesAsGlbWithItsThings) {
  if (!has_mannequin()) GTEST_SKIP() << "no mannequin";
  const DatasetPlan plan = plan_of_json(cup_plan());
  const WorkFolder work;
  ASSERT_TRUE(keep_plan(plan, work.path()));
  made(plan, {.folder = work.path(), .threads = 1});
  const WorkFolder out;
  const auto run = export_dataset({.from = work.path(), .to = out.path()});
  ASSERT_TRUE(run) << run.error().to_string();
  EXPECT_EQ(run->motions, 2U);
  EXPECT_EQ(run->left_out, 0U) << run->why;
  EXPECT_EQ(run->searched, 2U);
  EXPECT_EQ(run->missed, 0U);
  std::map<std::string, std::string> files;
  for (const auto& [name, bytes] : out.contents()) {
    if (name.ends_with(".glb")) files[name] = out.get(name);
  }
  ASSERT_EQ(files.size(), 2U);
  for (std::uint64_t number = 0; number < 2; ++number) {
    // the file that the task itself gives
    TaskFile file = plan.task(number).value().file;
    const Task task = make_task(file, {}).value();
    const Candidate found = perform(task).value().candidates.front();
    const std::string name = fmt::format("motions/0000/{:06}-1.glb", number);
    ASSERT_TRUE(files.contains(name));
    EXPECT_EQ(nodes_named(files[name], "cup"), 1);
    const auto own = export_candidate(file.character, task, found, FileFormat::glb,
                                      {.animation = fmt::format("{:06}-1", number)});
    ASSERT_TRUE(own);
    EXPECT_TRUE(*own == files[name]) << name;
  }
}

}  // namespace
}  // namespace shigusa
