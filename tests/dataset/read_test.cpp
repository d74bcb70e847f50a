// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <shigusa/dataset_read.hpp>
#include <shigusa/generate.hpp>

#include "dataset/plans.hpp"
#include "support/named_values.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// A data set of a few tasks in a folder.
struct Kept {
  WorkFolder work;
  DatasetPlan plan;

  explicit Kept(const Json& json) : plan(plan_of_json(json)) {
    EXPECT_TRUE(keep_plan(plan, work.path()));
    made(plan, {.folder = work.path()});
  }
};

Json loaded_plan() {
  Json json = small_plan(5, 2);
  json["series"] = Json::array();
  json["motions"] = "reached";
  json["task"]["goals"][0]["load_kg"] = Json{{"uniform", {0.5, 2.0}}};
  json["task"]["goals"][0]["tolerance_m"] = {0.01, 0.0, 0.02};
  return json;
}

// The task of a motion, as it was searched.
Task task_of(const DatasetPlan& plan, const DatasetMotion& motion) {
  TaskFile file = plan.task(motion.task).value().file;
  Task task = make_task(file, {}).value();
  task.duration = motion.duration;
  return task;
}

TEST(ReadMotions, ShowsWhatWasAskedOfWhom) {
  const Kept kept(loaded_plan());
  std::vector<std::pair<std::uint64_t, int>> shown;
  const auto read = read_motions(kept.work.path(), [&](const DatasetMotion& motion) {
    shown.emplace_back(motion.task, motion.rank);
    const Task task = task_of(kept.plan, motion);
    EXPECT_EQ(motion.goals, task.goals);
    EXPECT_EQ(motion.stature, task.body.stature());
    EXPECT_EQ(motion.mass, task.body.mass());
    EXPECT_FALSE(motion.seat);
    EXPECT_EQ(motion.names.size(), motion.parameters.size());
  });
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_THAT(shown, Not(IsEmpty()));
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  EXPECT_EQ(shown.back().first, 4u);
}

TEST(ReadMotions, TheirParametersMakeThemAgain) {
  const Kept kept(loaded_plan());
  int motions = 0;
  const auto read = read_motions(kept.work.path(), [&](const DatasetMotion& motion) {
    const Task task = task_of(kept.plan, motion);
    const Parameters values = named_parameters(task, motion.names, motion.parameters).value();
    const GenerateResult again = regenerate(task, values).value();
    EXPECT_EQ(again.candidates[0].score.total, motion.score);
    EXPECT_EQ(again.candidates[0].judgement.verdict, motion.verdict);
    ++motions;
  });
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_GE(motions, 5);
}

TEST(ReadMotions, OfADamagedShardFail) {
  const Kept kept(small_plan(2, 2));
  std::string bytes = kept.work.get(shard_name(0));
  bytes[bytes.size() / 2] ^= 1;
  kept.work.put(shard_name(0), bytes);
  const auto read = read_motions(kept.work.path(), [](const DatasetMotion&) {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().to_string(), HasSubstr("is damaged"));
}

TEST(NamedParameters, LeaveOutWhatTheTaskHasNot) {
  const Task task(half_body(), {.goals = {{"right_hand", {-0.2, 0.9, 0.3}}}});
  const std::vector<std::string> names{"right_elbow.flexion.weight", "tail.flexion.weight",
                                       "squat_rad", "left_hip.flexion.weight"};
  const std::vector<double> values{3.0, 2.0, 0.5, kNoNumber};
  const Parameters made = named_parameters(task, names, values).value();
  Parameters expected = uniform_parameters(task.body);
  expected.posed = true;
  testing_support::value_of(task, expected, "squat") = 0.5;
  const auto elbow = task.body.find_dof("right_elbow.flexion");
  expected.values[static_cast<std::size_t>(elbow.value())] = 3.0;
  if (const auto hip = task.body.find_dof("left_hip.flexion")) {
    expected.locked[static_cast<std::size_t>(*hip)] = true;
  }
  EXPECT_EQ(made, expected);
}

TEST(NamedParameters, AreStartsOfAnotherTask) {
  Json json = small_plan(1, 1);
  json["motions"] = "reached";
  const Kept kept(json);
  Task other(half_body({.stature = 1.6}), {.goals = {{"right_hand", {-0.2, 0.9, 0.3}}}});
  const auto read = read_motions(kept.work.path(), [&](const DatasetMotion& motion) {
    other.starts.push_back(named_parameters(other, motion.names, motion.parameters).value());
  });
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_THAT(other.starts, Not(IsEmpty()));
  EXPECT_TRUE(PreparedTask::of(other));
}

TEST(DatasetPlan, KeepsNoSeriesWhereNoneIsAskedFor) {
  Json json = small_plan(2, 2);
  json["series"] = Json::array();
  const DatasetPlan plan = plan_of_json(json);
  EXPECT_THAT(plan.series(), IsEmpty());
  json = Json::parse(plan.text());
  json["tasks"] = 2;
  EXPECT_THAT(plan_of_json(json).series(), IsEmpty());
}

}  // namespace
}  // namespace shigusa
