// SPDX-License-Identifier: MIT
// Pieces of work that are wrong in themselves or in their order are told with their place, before
// anything is searched.
#include <gtest/gtest.h>

#include <limits>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <string>

namespace shigusa {
namespace {

// A box and a cup before a person.
Task work_of(std::vector<Action> actions) {
  Task task(human_body(), {});
  task.things = {{.name = "box", .size = {0.3, 0.2, 0.3}, .mass = 3, .position = {0, 0.1, 0.45}},
                 {.name = "cup",
                  .shape = ThingShape::cylinder,
                  .size = {0.08, 0.1, 0.08},
                  .mass = 0.3,
                  .position = {-0.3, 0.9, 0.35}}};
  task.actions = std::move(actions);
  return task;
}

Action put(const std::string& thing) { return {.place = thing, .position = Vec3d{0, 1.0, 0.4}}; }

// The message and place of a task that fails.
std::string told(const Task& task) {
  const auto result = perform(task);
  if (result) return "nothing";
  return result.error().place + ": " + result.error().message.text;
}

void expect_told(const Task& task, const std::string& place, const std::string& words) {
  const std::string message = told(task);
  EXPECT_EQ(message.rfind(place + ": ", 0), 0U) << message;
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

TEST(WrongWork, AnActionThatCannotBeIsToldByItsNumber) {
  expect_told(work_of({{.grasp = "bax"}}), "actions[0]", "'box'");
  expect_told(work_of({put("box")}), "actions[0]", "box");
  expect_told(work_of({{.wait = 1.0}, {.release = "cup"}}), "actions[1]", "cup");
  expect_told(work_of({{.grasp = "box"}, {.grasp = "cup", .with = {"right_hand"}}}), "actions[1]",
              "holds box");
  expect_told(work_of({{.grasp = "cup"}, {.grasp = "cup"}}), "actions[1]", "cup");
  expect_told(work_of({{.grasp = "cup", .with = {"right_hand"}},
                       {.grasp = "box", .with = {"right_hand", "left_hand"}}}),
              "actions[1]", "holds cup");
  expect_told(work_of({{.grasp = "cup"}, {.release = "cup"}, {.release = "cup"}}), "actions[2]",
              "cup");
  expect_told(work_of({{.grasp = "cup"}, put("cup"), put("cup")}), "actions[2]", "cup");
  expect_told(work_of({{.grasp = "cup", .with = {"head"}}}), "actions[0]", "hand");
  expect_told(work_of({{.grasp = "cup"}, {.place = "cup"}}), "actions[1]", "position_m");
  expect_told(work_of({{}}), "actions[0]", "");
  expect_told(work_of({{.grasp = "cup", .wait = 1.0}}), "actions[0]", "");
}

TEST(WrongWork, WhatNeedsStepsIsToldSo) {
  Action sits;
  sits.sit.emplace();
  expect_told(work_of({{.grasp = "cup"}, sits}), "actions[1].sit", "needs steps");
  Action elsewhere;
  elsewhere.stand = Stance{.x = 0.6};
  const auto result = perform(work_of({elsewhere}));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::unsupported);
}

TEST(WrongWork, ThingsThatCannotBeAreTold) {
  Task task = work_of({{.grasp = "box"}});
  task.things[1].position = task.things[0].position;
  EXPECT_NE(told(task).find("mm in"), std::string::npos) << told(task);
  task = work_of({{.grasp = "box"}});
  task.obstacles = {{.name = "wall", .position = {0, 1, 0.45}, .size = {2, 2, 0.1}}};
  EXPECT_NE(told(task).find("in wall"), std::string::npos) << told(task);
  task = work_of({{.grasp = "box"}});
  task.things[0].mass = 1e4;
  EXPECT_NE(told(task).find("beyond any strength"), std::string::npos) << told(task);
  task = work_of({{.grasp = "box"}});
  task.things[1].name = "box";
  EXPECT_NE(told(task), "nothing");
  task = work_of({{.grasp = "box"}});
  task.things[0].position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(told(task), "nothing");
}

// Things that are in each other in a ring are told by the first pair.
TEST(WrongWork, ThingsInARingAreTold) {
  Task task = work_of({{.grasp = "box"}});
  task.things = {{.name = "a", .size = {0.3, 0.1, 0.1}, .position = {0, 0.9, 0.4}},
                 {.name = "b", .size = {0.1, 0.1, 0.3}, .position = {0.12, 0.9, 0.5}},
                 {.name = "c", .size = {0.3, 0.1, 0.1}, .position = {0, 0.9, 0.6}}};
  EXPECT_NE(told(task).find("mm in a"), std::string::npos) << told(task);
}

TEST(WrongWork, APlaceInMidAirIsAllowedAndNoted) {
  Task task = work_of({{.grasp = "cup"}, put("cup")});
  task.things.erase(task.things.begin());
  const std::vector<Message> notes = goal_notes(task);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].text, "cup is put in mid-air, where it stays");
  EXPECT_TRUE(perform(task).value().meets_goals());
  task.actions.back().position = Vec3d{0, 0.05, 0.4};
  EXPECT_TRUE(goal_notes(task).empty()) << "on the floor";
}

TEST(WrongWork, AThousandActionsAreTooMany) {
  expect_told(work_of(std::vector<Action>(1000, Action{.wait = 0.1})), "actions", "64");
}

// A place that is passed lies on the hand's way, which does not stop there.
TEST(Via, IsPassedWithoutAStop) {
  const Vec3d passed{-0.35, 1.3, 0.35};
  Task task(human_body(), {});
  Action via;
  via.goals = {{"right_hand", passed}};
  via.via = true;
  Action end;
  end.goals = {{"right_hand", {0.1, 1.2, 0.45}}};
  task.actions = {via, end};
  task.candidates = 1;
  const GenerateResult result = perform(task).value();
  ASSERT_TRUE(result.meets_goals());
  const Candidate& best = result.candidates.front();
  const auto& ways = best.motion.effectors;
  ASSERT_FALSE(ways.empty());
  double nearest = 1.0;
  double speed = 0.0;
  const std::vector<Vec3d>& way = ways.front();
  for (std::size_t f = 1; f + 1 < way.size(); ++f) {
    const double off = norm(way[f] - passed);
    if (off >= nearest) continue;
    nearest = off;
    speed = norm(way[f + 1] - way[f - 1]) / (2.0 * best.motion.clip.frame_time);
  }
  EXPECT_LT(nearest, 0.02);
  EXPECT_GT(speed, 0.2);
}

}  // namespace
}  // namespace shigusa
