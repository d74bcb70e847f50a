// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>

#include "dataset/plans.hpp"
#include "dataset/task_rows.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Dataset, SameBytesForAnyThreadsSimdSetAndOrder) {
  const DatasetPlan plan = plan_of_json(small_plan(7, 3));
  const WorkFolder one;
  const WorkFolder other;
  const DatasetRun run = made(plan, {.folder = one.path(), .threads = 1, .simd = SimdSet::scalar});
  EXPECT_EQ(run.made, 3u);
  EXPECT_EQ(run.tasks, 7u);
  for (const std::uint64_t shard : {2u, 0u, 1u}) {
    made(plan,
         {.folder = other.path(), .first_shard = shard, .last_shard = shard + 1, .threads = 3});
  }
  EXPECT_TRUE(one.contents() == other.contents());
  EXPECT_EQ(one.contents().size(), 3u);
}

TEST(Dataset, StaysWhereItIsAndGoesOn) {
  const DatasetPlan plan = plan_of_json(small_plan(7, 3));
  const WorkFolder whole;
  made(plan, {.folder = whole.path()});
  const WorkFolder work;
  made(plan, {.folder = work.path(), .last_shard = 1});
  const auto before = std::filesystem::last_write_time(work / shard_name(0));
  const DatasetRun rest = made(plan, {.folder = work.path()});
  EXPECT_EQ(rest.there, 1u);
  EXPECT_EQ(rest.made, 2u);
  EXPECT_EQ(std::filesystem::last_write_time(work / shard_name(0)), before);
  EXPECT_TRUE(work.contents() == whole.contents());
}

TEST(Dataset, CancelEndsOnAWholeShard) {
  const DatasetPlan plan = plan_of_json(small_plan(7, 3));
  const WorkFolder work;
  std::atomic<bool> cancel{false};
  const DatasetRun run = made(plan, {.folder = work.path(),
                                     .report =
                                         [&](const DatasetReport& now) {
                                           if (now.tasks > 0) cancel = true;
                                         },
                                     .cancel = &cancel});
  EXPECT_EQ(run.made, 1u);
  EXPECT_EQ(run.left, 2u);
  EXPECT_TRUE(ShardReader::open(work / shard_name(0)));
  EXPECT_EQ(work.contents().size(), 1u);
}

TEST(Dataset, AnotherPlansFolderIsRefused) {
  const WorkFolder work;
  made(plan_of_json(small_plan(3, 3)), {.folder = work.path()});
  Json json = small_plan(3, 3);
  json["seed"] = 8;
  const auto run = make_dataset(plan_of_json(json), {.folder = work.path()});
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().to_string(), HasSubstr("another plan"));
}

TEST(Dataset, ASetGrowsByItsLastShard) {
  const WorkFolder work;
  made(plan_of_json(small_plan(4, 3)), {.folder = work.path()});
  const std::string first = work.get(shard_name(0));
  const DatasetRun more = made(plan_of_json(small_plan(7, 3)), {.folder = work.path()});
  EXPECT_EQ(more.there, 1u);
  EXPECT_EQ(more.made, 2u);
  EXPECT_TRUE(work.get(shard_name(0)) == first);
  EXPECT_EQ(ShardTables(work.path(), 1).tasks.rows(), 3u);
}

TEST(Dataset, RowsAreThoseOfTheTaskMadeAlone) {
  Json json = small_plan(3, 3);
  json["series"] = all_words<DatasetSeries>();
  json["task"]["character"]["source"] = "human";
  json["task"]["preset"] = "flat";
  const DatasetPlan plan = plan_of_json(json);
  const WorkFolder work;
  made(plan, {.folder = work.path()});
  ShardTables shard(work.path(), 0);
  const DrawnTask drawn = plan.task(1).value();
  TaskFile file = drawn.file;
  const Task task = make_task(file, {}).value();
  const GenerateResult alone = generate(task).value();
  const auto numbers = shard.motions["task"].as<std::uint64_t>();
  const auto row =
      static_cast<std::size_t>(std::find(numbers.begin(), numbers.end(), 1u) - numbers.begin());
  ASSERT_LT(row, numbers.size());
  EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 1u),
            static_cast<long>(alone.candidates.size()));
  const Candidate& best = alone.candidates.front();
  EXPECT_EQ(shard.motions["score"].as<double>()[row], best.score.total);
  EXPECT_EQ(shard.motions["words"].texts()[row], posture_words(best.final_posture));
  const auto angles = shard.motions["angles"].as<float>();
  const auto torques = shard.motions["torques"].as<float>();
  const std::size_t size = shard.motions["angles"].row_size() / sizeof(float);
  ASSERT_EQ(size, best.motion.clip.angles.size());
  for (std::size_t i = 0; i < size; ++i) {
    ASSERT_EQ(angles[row * size + i], static_cast<float>(best.motion.clip.angles[i]));
    ASSERT_EQ(torques[row * size + i], static_cast<float>(best.motion.torques[i]));
  }
  // the goal's node is at the goal at the end
  const auto& nodes = *shard.motions.names_of("nodes");
  const auto hand = static_cast<std::size_t>(
      std::find(nodes.begin(), nodes.end(), best.goals.front().node) - nodes.begin());
  ASSERT_LT(hand, nodes.size());
  const auto positions = shard.motions["positions"].as<float>();
  const std::size_t last = ((row * 61 + 60) * nodes.size() + hand) * 3;
  const Vec3d& goal = drawn.file.goals.front().position;
  EXPECT_NEAR(positions[last], goal.x, 1e-3);
  EXPECT_NEAR(positions[last + 1], goal.y, 1e-3);
  EXPECT_NEAR(positions[last + 2], goal.z, 1e-3);
  // and by turns and offsets alone the nodes are where they are
  const auto turns = shard.motions["nodes"].as<float>();
  const auto roots = shard.motions["root_m"].as<float>();
  const auto offsets = shard.motions["offsets_m"].as<float>();
  const auto& parents = *shard.motions.names_of("node_parents");
  for (const std::size_t frame : {std::size_t{0}, std::size_t{30}, std::size_t{60}}) {
    std::vector<Vec3d> at(nodes.size());
    std::vector<Quatd> turn(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const float* q = &turns[((row * 61 + frame) * nodes.size() + n) * 4];
      const Quatd own{q[0], q[1], q[2], q[3]};
      const auto parent = static_cast<std::size_t>(
          std::find(nodes.begin(), nodes.end(), parents[n]) - nodes.begin());
      if (parent == nodes.size()) {
        const float* p = &roots[(row * 61 + frame) * 3];
        at[n] = {p[0], p[1], p[2]};
        turn[n] = own;
      } else {
        const float* o = &offsets[(row * nodes.size() + n) * 3];
        at[n] = at[parent] + to_matrix(turn[parent]) * Vec3d{o[0], o[1], o[2]};
        turn[n] = turn[parent] * own;
      }
      const float* p = &positions[((row * 61 + frame) * nodes.size() + n) * 3];
      // single precision along a chain of ten nodes
      EXPECT_LT(norm(at[n] - Vec3d{p[0], p[1], p[2]}), 1e-5) << nodes[n];
    }
  }
}

// A body that stands on its left foot has its dofs in another order.
TEST(Dataset, JointsHaveOneOrderWhicheverFootStands) {
  Json json = small_plan(2, 2);
  json["motions"] = "all";
  json["task"]["character"]["source"] = "full_body";
  json["task"]["goals"] = {
      {"choice",
       Json::array(
           {Json::array({Json{{"effector", "right_foot"}, {"position_m", {-0.1, 0.2, 0.2}}}}),
            Json::array({Json{{"effector", "left_foot"}, {"position_m", {0.1, 0.2, 0.2}}}})})},
      {"shares", {1, 0}}};
  const WorkFolder work;
  made(plan_of_json(json), {.folder = work.path()});
  ShardTables lifted_right(work.path(), 0);
  json["task"]["goals"]["shares"] = {0, 1};
  const WorkFolder other;
  made(plan_of_json(json), {.folder = other.path()});
  ShardTables lifted_left(other.path(), 0);
  EXPECT_EQ(lifted_right.motions.path, lifted_left.motions.path);
  EXPECT_EQ(*lifted_right.motions.names_of("joints"), *lifted_left.motions.names_of("joints"));
}

TEST(Dataset, WhatIsMissedIsTold) {
  Json json = small_plan(2, 2);
  json["task"]["goals"][0]["position_m"] = {-0.2, 1.0, 3.0};
  const WorkFolder work;
  const DatasetRun run = made(plan_of_json(json), {.folder = work.path()});
  EXPECT_EQ(run.motions, 0u);
  ShardTables shard(work.path(), 0);
  EXPECT_EQ(shard.motions.rows(), 0u);
  ASSERT_EQ(shard.missed.rows(), 2u);
  EXPECT_THAT(shard.missed["effector"].texts(), ElementsAre("right_hand", "right_hand"));
  EXPECT_GT(shard.missed["error_m"].as<double>()[0], 1.0);
  const auto status = shard.tasks["status"].as<std::uint8_t>();
  EXPECT_EQ(shard.tasks["status"].words[status[0]], "unreachable");
}

TEST(Dataset, ATaskThatCannotBeAskedForIsARow) {
  Json json = small_plan(2, 2);
  // no person of any stature of it has such a place in reach
  json["task"]["goals"][0]["position_m"] = {{"reach", {{3, 3, 3}, {3.1, 3.1, 3.1}}}};
  const WorkFolder work;
  made(plan_of_json(json), {.folder = work.path()});
  ShardTables shard(work.path(), 0);
  const auto status = shard.tasks["status"].as<std::uint8_t>();
  EXPECT_EQ(shard.tasks["status"].words[status[0]], kRefused);
  EXPECT_THAT(shard.tasks["refused"].texts()[0], HasSubstr("none is in reach"));
}

TEST(Dataset, OnlyPossibleMotionsWhereAskedFor) {
  Json json = small_plan(4, 4);
  json["task"]["goals"][0]["load_kg"] = 60;
  const WorkFolder all;
  const DatasetRun every = made(plan_of_json(json), {.folder = all.path()});
  json["motions"] = "possible";
  const WorkFolder work;
  const DatasetRun some = made(plan_of_json(json), {.folder = work.path()});
  EXPECT_LT(some.motions, every.motions);
}

}  // namespace
}  // namespace shigusa
