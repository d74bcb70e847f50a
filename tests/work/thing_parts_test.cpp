// SPDX-License-Identifier: MIT
// A thing of parts is held, carried and weighed by its form, not by the box about it.
#include <gmock/gmock.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "kinematics/penetration.hpp"
#include "work/hold.hpp"

namespace shigusa {
namespace {

using testing::HasSubstr;

// A bar on the floor with a post at its right end.
Thing bracket() {
  return {.name = "bracket",
          .size = {0.5, 0.4, 0.2},
          .mass = 6,
          .position = {0, 0.2, 0.5},
          .centre = {-0.08, -0.08, 0},
          .parts = {{{0, -0.15, 0}, {0.5, 0.1, 0.2}}, {{-0.2, 0.05, 0}, {0.1, 0.3, 0.2}}}};
}

Task work_with(Thing thing) {
  Task task(human_body(), {});
  const std::string name = thing.name;
  task.things = {std::move(thing)};
  task.actions = {{.grasp = name}, {.place = name, .position = Vec3d{0, 1.0, 0.45}}};
  return task;
}

TEST(ThingParts, HandsLieOnItsSurface) {
  const Task task = work_with(bracket());
  const Thing& thing = task.things.front();
  const Kinematics<double> at = placed(task.body, task.home);
  const Transformd pose = start_pose(thing);
  const std::vector<PlacedBox> parts = placed_boxes(obstacles_of(thing, pose));
  ASSERT_EQ(parts.size(), 2U);
  const Holds holds = holds_of(task.body, at, thing, pose, {}, {});
  ASSERT_FALSE(holds.empty());
  Thing whole = thing;
  whole.parts.clear();
  const auto usual = holds_of(task.body, at, whole, pose, {}, {}).front();
  const std::vector<PlacedBox> box = placed_boxes(obstacles_of(whole, pose));
  for (const std::vector<Goal>& hold : holds) {
    ASSERT_EQ(hold.size(), 2U);
    for (const Goal& goal : hold) {
      EXPECT_NEAR(least_distance(parts, goal.position), least_distance(box, usual[0].position),
                  1e-3)
          << goal.effector;
    }
  }
  // on the box's sides the left hand would be above the bar, in the air
  EXPECT_GT(least_distance(parts, usual[1].position), 0.08);
}

TEST(ThingParts, IsPutWhereItIsToGo) {
  const GenerateResult made = perform(work_with(bracket())).value();
  EXPECT_TRUE(made.meets_goals());
  EXPECT_NE(made.candidates.front().judgement.verdict, Verdict::impossible);
  EXPECT_LT(made.candidates.front().actions[1].placed->error, 1e-3);
}

// Two sticks of 2 cm are narrower than a palm.
TEST(ThingParts, ThinOnesAreTakenToo) {
  for (const std::vector<std::string>& hands : {std::vector<std::string>{"right_hand"}, {}}) {
    Task task = work_with({.name = "cross",
                           .size = {0.3, 0.3, 0.02},
                           .mass = 0.5,
                           .position = {-0.1, 1.0, 0.4},
                           .parts = {{{}, {0.3, 0.02, 0.02}}, {{}, {0.02, 0.3, 0.02}}}});
    task.actions[0].with = hands;
    EXPECT_TRUE(perform(task).value().meets_goals());
  }
}

TEST(ThingParts, TwoHalvesAreABox) {
  Thing box{.name = "box", .size = {0.4, 0.3, 0.2}, .mass = 5, .position = {0, 0.15, 0.5}};
  const Task task = work_with(box);
  const Grip grip{.hand = task.body.find_effector("right_hand").value(), .in_hand = {}};
  const HeldLoad whole = load_of(task.body, box, grip, 1, true);
  box.parts = {{{-0.1, 0, 0}, {0.2, 0.3, 0.2}}, {{0.1, 0, 0}, {0.2, 0.3, 0.2}}};
  const HeldLoad halves = load_of(task.body, box, grip, 1, true);
  EXPECT_EQ(halves.parts.size(), 2U);
  EXPECT_LT(norm(halves.inertia - whole.inertia), 1e-12);
  EXPECT_EQ(halves.centre, whole.centre);
}

// A ball within an open crate is taken out from above.
TEST(ThingParts, WhatIsOpenCanBeReachedInto) {
  Task task(human_body(), {});
  task.things = {{.name = "ball",
                  .shape = ThingShape::sphere,
                  .size = {0.09, 0.09, 0.09},
                  .mass = 0.4,
                  .position = {-0.2, 0.585, 0.4}},
                 {.name = "crate",
                  .size = {0.4, 0.16, 0.36},
                  .mass = 2,
                  .position = {-0.2, 0.6, 0.4},
                  .parts = {{{0, -0.07, 0}, {0.4, 0.02, 0.36}},
                            {{-0.19, 0.01, 0}, {0.02, 0.14, 0.36}},
                            {{0.19, 0.01, 0}, {0.02, 0.14, 0.36}},
                            {{0, 0.01, 0.17}, {0.36, 0.14, 0.02}},
                            {{0, 0.01, -0.17}, {0.36, 0.14, 0.02}}}}};
  task.actions = {{.grasp = "ball"}, {.place = "ball", .position = Vec3d{-0.3, 1.1, 0.4}}};
  const GenerateResult made = perform(task).value();
  EXPECT_TRUE(made.meets_goals());
  EXPECT_EQ(made.candidates.front().judgement.verdict, Verdict::possible);
  task.things[1].parts.clear();
  const auto full = perform(task);
  ASSERT_FALSE(full);
  EXPECT_THAT(full.error().message.text, HasSubstr("in ball"));
}

TEST(ThingParts, WrongOnesAreTold) {
  const auto told = [](const Thing& thing) {
    const auto made = perform(work_with(thing));
    return made ? "nothing" : made.error().place + ": " + made.error().message.text;
  };
  Thing thing = bracket();
  thing.parts[0].position.x = 0.1;
  EXPECT_THAT(told(thing), HasSubstr("thing bracket: a part leaves its side along x of 0.5 m, or"));
  thing = bracket();
  thing.parts[1].size.z = 0.0;
  EXPECT_THAT(told(thing), HasSubstr("has no size"));
  thing = bracket();
  thing.shape = ThingShape::cylinder;
  EXPECT_THAT(told(thing), HasSubstr("only a box has parts"));
  thing = bracket();
  thing.parts.resize(kPartsMax + 1);
  EXPECT_THAT(told(thing), HasSubstr("allowed"));
  Task task = work_with(bracket());
  for (std::size_t k = 0; k < kObstaclesMax; ++k) {
    task.obstacles.push_back({.name = "stone", .position = {5, 5, 5}, .radius = 0.1});
  }
  const auto made = perform(task);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message.text, HasSubstr("obstacles and parts of things are 66"));
}

}  // namespace
}  // namespace shigusa
