// SPDX-License-Identifier: MIT
// Things that stand on things.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>
#include <shigusa/character.hpp>
#include <shigusa/generate.hpp>
#include <string>

#include "core/say.hpp"

namespace shigusa {
namespace {

constexpr double kExact = 1e-3;  // m

Thing box_at(const std::string& name, const Vec3d& size, const Vec3d& position, double mass) {
  return {.name = name, .size = size, .mass = mass, .position = position};
}

Task task_of(std::vector<Thing> things, std::vector<Action> actions) {
  Task task(build_character({}).value());
  task.things = std::move(things);
  task.actions = std::move(actions);
  task.candidates = 2;
  return task;
}

Action put(const std::string& thing, const Vec3d& at) { return {.place = thing, .position = at}; }

// All is done to within 1 mm by a motion that a body can make.
void expect_done(const Task& task) {
  const auto result = perform(task);
  ASSERT_TRUE(result) << result.error().to_string();
  ASSERT_TRUE(result->meets_goals()) << result->conflict.text;
  const Candidate& best = result->candidates.front();
  std::string why;
  for (const Reason& reason : best.judgement.reasons) why += reason_words(reason) + "; ";
  EXPECT_NE(best.judgement.verdict, Verdict::impossible) << why;
  for (const ActionResult& action : best.actions) {
    EXPECT_LE(action.placed ? action.placed->error : 0.0, kExact);
  }
}

const Vec3d kCrate{0.34, 0.24, 0.26};

TEST(Stacks, ABoxIsPutOnABox) {
  expect_done(task_of({box_at("lower", kCrate, {0.3, 0.12, 0.42}, 4),
                       box_at("upper", kCrate, {-0.25, 0.12, 0.42}, 4)},
                      {{.grasp = "upper"}, put("upper", {0.3, 0.36, 0.42})}));
}

TEST(Stacks, TheUpperOneOfTwoIsTakenOff) {
  expect_done(task_of({box_at("lower", kCrate, {0.25, 0.12, 0.42}, 4),
                       box_at("upper", kCrate, {0.25, 0.36, 0.42}, 4)},
                      {{.grasp = "upper"}, put("upper", {-0.25, 0.12, 0.42})}));
}

TEST(Stacks, ATowerIsMovedOneByOne) {
  expect_done(task_of({box_at("lower", kCrate, {0.25, 0.12, 0.42}, 3),
                       box_at("upper", kCrate, {0.25, 0.36, 0.42}, 3)},
                      {{.grasp = "upper"},
                       put("upper", {-0.25, 0.12, 0.42}),
                       {.grasp = "lower"},
                       put("lower", {-0.25, 0.36, 0.42})}));
}

TEST(Stacks, SmallThingsAreStackedByOneHand) {
  const Obstacle table{.name = "table", .position = {0, 0.8, 0.65}, .size = {1.4, 0.05, 0.7}};
  for (const ThingShape shape : {ThingShape::box, ThingShape::cylinder, ThingShape::sphere}) {
    Task task = task_of(
        {box_at("base", {0.2, 0.06, 0.2}, {-0.1, 0.855, 0.5}, 1),
         {.name = "top",
          .shape = shape,
          .size = {0.07, shape == ThingShape::sphere ? 0.07 : 0.12, 0.07},
          .mass = 0.3,
          .position = {-0.35, shape == ThingShape::sphere ? 0.86 : 0.885, 0.45}}},
        {{.grasp = "top"}, put("top", {-0.1, shape == ThingShape::sphere ? 0.92 : 0.945, 0.5})});
    task.obstacles = {table};
    SCOPED_TRACE(word_of(shape));
    expect_done(task);
  }
}

}  // namespace
}  // namespace shigusa
