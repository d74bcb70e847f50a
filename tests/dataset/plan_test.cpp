// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "dataset/plans.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const Json& json) {
  const auto plan = DatasetPlan::parse(json.dump(), "plan.json", {});
  return plan ? "" : plan.error().to_string();
}

Json with(const std::string& pointer, const Json& value) {
  Json json = small_plan(10, 5);
  json[Json::json_pointer(pointer)] = value;
  return json;
}

TEST(DatasetPlan, CutsTasksIntoShardsWithoutAGap) {
  const DatasetPlan plan = plan_of_json(small_plan(1'000'003, 250));
  EXPECT_EQ(plan.shards(), 4001u);
  std::uint64_t next = 0;
  for (std::uint64_t shard = 0; shard < plan.shards(); ++shard) {
    const TaskRange range = plan.tasks_of(shard);
    ASSERT_EQ(range.first, next);
    ASSERT_LE(range.last - range.first, 250u);
    next = range.last;
  }
  EXPECT_EQ(next, 1'000'003u);
}

TEST(DatasetPlan, TasksDependOnTheirNumberAlone) {
  const DatasetPlan ten = plan_of_json(small_plan(10, 5));
  const DatasetPlan many = plan_of_json(small_plan(100'000, 5));
  for (const std::uint64_t k : {9u, 0u, 4u}) {
    EXPECT_EQ(format_task(ten.task(k)->file), format_task(many.task(k)->file));
  }
  EXPECT_NE(format_task(ten.task(1)->file), format_task(ten.task(2)->file));
  EXPECT_NE(ten.task(1)->file.seed, ten.task(2)->file.seed);
}

TEST(DatasetPlan, ASetCanGrow) {
  Json grown = small_plan(1000, 5);
  grown["name"] = "more of it";
  EXPECT_EQ(plan_of_json(small_plan(10, 5)).digest(), plan_of_json(grown).digest());
  EXPECT_NE(plan_of_json(small_plan(10, 5)).digest(), plan_of_json(with("/seed", 8)).digest());
  EXPECT_NE(plan_of_json(small_plan(10, 5)).digest(),
            plan_of_json(with("/task/evaluations", 121)).digest());
}

TEST(DatasetPlan, TasksOfAPersonAreOfThatPerson) {
  const DatasetPlan plan = plan_of_json(with("/people", 3));
  std::map<std::uint64_t, double> statures;
  for (std::uint64_t k = 0; k < 10; ++k) {
    const DrawnTask task = plan.task(k).value();
    ASSERT_LT(task.person, 3u);
    const auto [known, is_new] = statures.emplace(task.person, *task.file.character.stature);
    EXPECT_EQ(known->second, *task.file.character.stature);
  }
  EXPECT_GT(statures.size(), 1u);
}

TEST(DatasetPlan, HabitsAreDrawnByTheirShares) {
  Json json = small_plan(400, 100);
  json["task"]["habit"] = {{"choice", {"stoop", {{"knees", {{"uniform", {2.0, 3.0}}}}}}},
                           {"shares", {1, 3}}};
  const DatasetPlan plan = plan_of_json(json);
  int stoops = 0;
  for (std::uint64_t i = 0; i < plan.tasks(); ++i) {
    const Habit habit = plan.task(i).value().file.habit;
    if (habit.knees < 1.0) {
      ++stoops;
    } else {
      EXPECT_GE(habit.knees, 2.0);
      EXPECT_LE(habit.knees, 3.0);
    }
  }
  EXPECT_NEAR(stoops, 100, 40);  // a standard deviation of 9
}

TEST(DatasetPlan, WrongPlansAreToldBeforeAnyWork) {
  EXPECT_THAT(complaint(with("/sead", 1)),
              AllOf(HasSubstr("unknown key 'sead'"), HasSubstr("seed")));
  EXPECT_THAT(complaint(with("/tasks", 1'000'000'000'000)),
              AllOf(HasSubstr("plan.json: tasks"), HasSubstr("1000000000")));
  EXPECT_THAT(complaint(with("/tasks", 0)), HasSubstr("plan.json: tasks"));
  EXPECT_THAT(complaint(with("/shard_tasks", 1'000'000)),
              AllOf(HasSubstr("shard_tasks: is 1000000"), HasSubstr("a shard has at most")));
  EXPECT_THAT(complaint(with("/series", {"angels"})), HasSubstr("did you mean 'angles'"));
  EXPECT_THAT(complaint(with("/task", 3)), HasSubstr("plan.json: task"));
  EXPECT_THAT(complaint(with("/task/gaols", Json::array())), HasSubstr("unknown key 'gaols'"));
  EXPECT_THAT(complaint(with("/task/goals/0/load_kg", {{"uniform", {10, 5}}})),
              HasSubstr("plan.json: task.goals[0].load_kg.uniform: is [10,5]"));
  EXPECT_THAT(complaint(with("/task/goals/0/load_kg", {{"uniform", {0, 5000}}})),
              AllOf(HasSubstr("task: goals[0].load_kg"), HasSubstr("5000")));
  EXPECT_THAT(complaint(with("/task/character/source", "hero.mp3")), HasSubstr("hero.mp3"));
  EXPECT_THAT(complaint(with("/task/character", {{"source", "nobody.glb"}})),
              HasSubstr("nobody.glb"));
  // the second alternative alone is wrong
  EXPECT_THAT(complaint(with("/task/preset", {{"choice", {"flat", "flta"}}})),
              HasSubstr("did you mean 'flat'"));
  EXPECT_THAT(complaint(Json::array()), HasSubstr("plan.json"));
}

TEST(DatasetPlan, ShardsOfManySeriesHaveFewerTasks) {
  Json json = small_plan(1000, 5);
  json.erase("shard_tasks");
  const std::uint64_t few = plan_of_json(json).shard_tasks();
  json["series"] = {"angles", "torques", "nodes", "positions", "pressure", "contacts"};
  json["task"]["candidates"] = 20;
  const std::uint64_t fewer = plan_of_json(json).shard_tasks();
  EXPECT_LT(fewer, few);
  EXPECT_GE(fewer, 1u);
}

TEST(DatasetPlan, ACopyElsewhereFindsTheSameCharacters) {
  const std::filesystem::path shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "needs characters of ../shared";
  const std::string file = "lab0_CesiumMan.glb";
  const WorkFolder work;
  work.put("plans/" + file,
           read_text_file(shared / "characters" / file, kCharacterMaxBytes).value());
  Json json = with("/task/character", {{"source", file}, {"stature_m", {{"uniform", {1.5, 1.8}}}}});
  json["task"]["preset"] = "flat";
  const DatasetPlan plan = plan_of_json(json, work / "plans");
  work.put("data/plan.json", plan.text_in(work / "data"));
  const auto copy = DatasetPlan::read(work / "data/plan.json");
  ASSERT_TRUE(copy) << copy.error().to_string();
  EXPECT_EQ(copy->digest(), plan.digest());
  EXPECT_EQ(copy->task(3)->file.character.landmarks.has_value(), true);
}

}  // namespace
}  // namespace shigusa
