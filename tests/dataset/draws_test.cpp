// SPDX-License-Identifier: MIT
#include "dataset/draws.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <shigusa/files.hpp>
#include <shigusa/math.hpp>

#include "body/anthropometry.hpp"

namespace shigusa {
namespace {

using testing::HasSubstr;

Result<Task> human_task(const Json& character, const Json& goal) {
  Json json{{"character", character.is_null() ? Json("human") : character}};
  if (!goal.is_null()) json["goals"] = Json::array({goal});
  auto file = parse_task(json.dump(), "task");
  if (!file) return tl::unexpected(file.error());
  return make_task(*file, {});
}

Json drawn_from(const Json& form, std::uint64_t task, std::uint64_t seed = 7) {
  const auto json = drawn(form, {.seed = seed, .task = task, .person = task}, human_task);
  EXPECT_TRUE(json) << json.error().to_string();
  return json.value_or(Json());
}

std::string complaint(const std::string& form) {
  const auto checked = check_draws(Json::parse(form), "task");
  return checked ? "" : checked.error().to_string();
}

TEST(Draws, NumbersFillTheirRangeEvenly) {
  const Json form = Json::parse(R"({"ease": {"uniform": [2, 4]}, "phases": {"integer": [1, 3]}})");
  double sum = 0.0;
  std::array<int, 4> counts{};
  constexpr int kTasks = 4000;
  for (int i = 0; i < kTasks; ++i) {
    const Json json = drawn_from(form, static_cast<std::uint64_t>(i));
    const double value = json["ease"].get<double>();
    EXPECT_GE(value, 2.0);
    EXPECT_LT(value, 4.0);
    sum += value;
    ++counts[json["phases"].get<std::size_t>()];
  }
  // a mean of 4000 has the standard deviation 2 / sqrt(12 · 4000) = 0.009, a count that of 30
  EXPECT_NEAR(sum / kTasks, 3.0, 0.04);
  EXPECT_EQ(counts[0], 0);
  for (int k = 1; k <= 3; ++k) EXPECT_NEAR(counts[static_cast<std::size_t>(k)], kTasks / 3, 120);
}

TEST(Draws, ChoicesGoByTheirShares) {
  const Json form =
      Json::parse(R"({"preset": {"choice": ["flat", "paper", "human"], "shares": [3, 0, 1]}})");
  int flat = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Json json = drawn_from(form, i);
    EXPECT_NE(json["preset"], "paper");
    flat += json["preset"] == "flat" ? 1 : 0;
  }
  EXPECT_NEAR(flat, 1500, 80);  // a standard deviation of 19
}

TEST(Draws, AnotherDrawChangesNoOther) {
  const Json few = Json::parse(R"({"character": {"stature_m": {"percentile": [5, 95]}},
    "goals": [{"effector": "right_hand", "position_m": {"box_m": [[0, 0, 0], [1, 1, 1]]}}]})");
  Json more = few;
  more["character"]["mass_kg"] = {{"bmi", {18, 30}}};
  more["goals"][0]["load_kg"] = {{"uniform", {0, 10}}};
  more["duration_s"] = {{"uniform", {1, 2}}};
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Json a = drawn_from(few, i);
    const Json b = drawn_from(more, i);
    EXPECT_EQ(a["character"]["stature_m"], b["character"]["stature_m"]);
    EXPECT_EQ(a["goals"][0]["position_m"], b["goals"][0]["position_m"]);
    EXPECT_NE(a["character"]["stature_m"], drawn_from(few, i, 8)["character"]["stature_m"]);
  }
}

TEST(Draws, StaturesHaveTheTablesPercentiles) {
  for (const Sex sex : {Sex::male, Sex::female}) {
    EXPECT_NEAR(stature_at(5, sex), *stature_percentile("p5", sex), 1e-9);
    EXPECT_NEAR(stature_at(50, sex), *stature_percentile("p50", sex), 1e-9);
    EXPECT_NEAR(stature_at(95, sex), *stature_percentile("p95", sex), 1e-9);
    double before = 0.0;
    for (double percent = 0.1; percent < 99.95; percent += 0.1) {
      EXPECT_GT(stature_at(percent, sex), before);
      before = stature_at(percent, sex);
    }
  }
  // the normal distribution's quantile of 99.9 % is 3.0902
  const double sigma = (1.867 - 1.755) / 1.6448536269514722;
  EXPECT_NEAR(stature_at(99.9, Sex::male), 1.755 + 3.0902 * sigma, 1e-4);
}

TEST(Draws, MassGoesByStatureWhateverTheOrder) {
  const Json form = Json::parse(
      R"({"character": {"mass_kg": {"bmi": [25, 25]}, "stature_m": {"uniform": [1.5, 1.9]}}})");
  const Json who = drawn_from(form, 3)["character"];
  const double stature = who["stature_m"].get<double>();
  EXPECT_NEAR(who["mass_kg"].get<double>(), 25.0 * stature * stature, 1e-12);
}

TEST(Draws, AGoalCanStandBesideAnother) {
  const Json form = Json::parse(R"({"goals": [
    {"effector": "right_hand", "position_m": {"box_m": [[-0.3, 0.8, 0.3], [0.1, 1.2, 0.5]]}},
    {"effector": "left_hand", "position_m": {"beside": {"goal": 0, "offset_m": [0.4, 0, 0]}}}]})");
  const Json goals = drawn_from(form, 5)["goals"];
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_DOUBLE_EQ(goals[1]["position_m"][k].get<double>(),
                     goals[0]["position_m"][k].get<double>() + (k == 0 ? 0.4 : 0.0));
  }
  const auto later = drawn(
      Json::parse(R"({"goals": [{"position_m": {"beside": {"goal": 0, "offset_m": [0, 0, 0]}}}]})"),
      {}, human_task);
  ASSERT_FALSE(later);
  EXPECT_THAT(later.error().to_string(), HasSubstr("no earlier goal"));
}

TEST(Draws, PointsOfASurfaceAreOnIt) {
  const Json form = Json::parse(
      R"({"look_at_m": {"surface_m": {"corner": [0, 1, 0], "along": [[1, 0, 0], [0, 0, 2]]}}})");
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Json point = drawn_from(form, i)["look_at_m"];
    EXPECT_EQ(point[1], 1.0);
    EXPECT_THAT(point[0].get<double>(), testing::AllOf(testing::Ge(0.0), testing::Le(1.0)));
    EXPECT_THAT(point[2].get<double>(), testing::AllOf(testing::Ge(0.0), testing::Le(2.0)));
  }
}

TEST(Draws, RotationsPointEveryWhereAlike) {
  const Json form = Json::parse(R"({"goals": [{"rotation_xyzw": {"rotation": "any"}}]})");
  Vec3d mean{};
  constexpr int kTasks = 2000;
  for (int i = 0; i < kTasks; ++i) {
    const Json q = drawn_from(form, static_cast<std::uint64_t>(i))["goals"][0]["rotation_xyzw"];
    const Quatd turn{q[0], q[1], q[2], q[3]};
    EXPECT_NEAR(squared_length(turn), 1.0, 1e-12);
    mean += to_matrix(turn).cy * (1.0 / kTasks);
  }
  // each part of a mean of 2000 has the standard deviation 1 / sqrt(3 · 2000) = 0.013
  EXPECT_LT(norm(mean), 0.06);
}

TEST(Draws, PlacesInReachAreReached) {
  const Json form = Json::parse(R"({"character": "human", "goals": [{"effector": "left_hand",
    "position_m": {"reach": [[-2, 0, -2], [2, 2.5, 2]]}}]})");
  std::set<double> seen;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const Json goals = drawn_from(form, i)["goals"];
    const Vec3d at{goals[0]["position_m"][0], goals[0]["position_m"][1], goals[0]["position_m"][2]};
    // nobody reaches farther from their place than their height with an arm up
    EXPECT_LT(norm(at), 2.4);
    seen.insert(at.x);
  }
  EXPECT_EQ(seen.size(), 8u);
}

TEST(Draws, WrongDrawsAreToldWithTheirPlace) {
  EXPECT_THAT(complaint(R"({"ease": {"uniform": [4, 2]}})"),
              HasSubstr("task.ease.uniform: is [4,2]; allowed is [low, high] with low ≤ high"));
  EXPECT_THAT(complaint(R"({"ease": {"uniform": 3}})"), HasSubstr("allowed is [low, high]"));
  EXPECT_THAT(complaint(R"({"ease": {"uniform": [0, 1], "seed": 3}})"),
              HasSubstr("task.ease: 'seed' stands beside 'uniform'"));
  EXPECT_THAT(complaint(R"({"goals": {"choice": []}})"), HasSubstr("a list with a value"));
  EXPECT_THAT(complaint(R"({"goals": {"choice": [1, 2], "shares": [1]}})"),
              HasSubstr("task.goals.shares"));
  EXPECT_THAT(complaint(R"({"goals": {"choice": [1, 2], "shares": [0, 0]}})"),
              HasSubstr("not all 0"));
  EXPECT_THAT(complaint(R"({"goals": [{"position_m": {"box_m": [[1, 0, 0], [0, 1, 1]]}}]})"),
              HasSubstr("task.goals[0].position_m.box_m"));
  EXPECT_THAT(complaint(R"({"x": {"choice": [{"percentile": [0, 95]}]}})"),
              HasSubstr("task.x.choice[0].percentile"));
  EXPECT_THAT(complaint(R"({"x": {"surface_m": {"corner": [0, 0, 0]}}})"), HasSubstr("along"));
  EXPECT_THAT(complaint(R"({"x": {"beside": {"goal": 0, "offset_m": {"uniform": []}}}})"),
              HasSubstr("offset_m.uniform"));
  EXPECT_THAT(complaint(R"({"x": {"rotation": "some"}})"), HasSubstr("allowed is \"any\""));
}

// A task's own members must never be mistaken for draws.
TEST(Draws, NoFieldOfATaskHasADrawsWord) {
  const Json schema = Json::parse(task_schema());
  const std::string text = schema.dump();
  for (const DrawInfo& info : kDraws) {
    EXPECT_EQ(text.find("\"" + std::string(info.word) + "\":"), std::string::npos) << info.word;
  }
  EXPECT_EQ(text.find("\"shares\":"), std::string::npos);
}

}  // namespace
}  // namespace shigusa
