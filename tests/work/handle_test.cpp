// SPDX-License-Identifier: MIT
// Things with handles are taken around the bar, by one hand.
#include <gtest/gtest.h>

#include <shigusa/character.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/kinematics.hpp>
#include <string>

#include "core/say.hpp"
#include "work/check_work.hpp"
#include "work/hold.hpp"
#include "work/moment.hpp"

namespace shigusa {
namespace {

constexpr double kExact = 1e-3;       // m
constexpr double kWithinPalm = 0.05;  // m, of a bar from the point of the hand around it

Task task_of(const Thing& thing, const Vec3d& to) {
  Task task(build_character({}).value());
  task.things = {thing};
  task.actions = {{.grasp = thing.name}, {.place = thing.name, .position = to}};
  task.candidates = 1;
  return task;
}

// The bar is in the hand, along its thumb, while the thing moves; nothing else is missed.
void expect_held_by_the_bar(const Task& task) {
  const auto result = perform(task);
  ASSERT_TRUE(result) << result.error().to_string();
  ASSERT_TRUE(result->meets_goals()) << result->conflict.text;
  const Candidate& best = result->candidates.front();
  EXPECT_NE(best.judgement.verdict, Verdict::impossible)
      << (best.judgement.reasons.empty() ? "" : reason_words(best.judgement.reasons.front()));
  ASSERT_EQ(best.actions[0].goals.size(), 1u) << "one hand";
  ASSERT_TRUE(best.actions[1].placed);
  EXPECT_LE(best.actions[1].placed->error, kExact);
  const int hand = *task.body.find_effector(best.actions[0].goals[0].asked.effector);
  const Effector& effector = task.body.effector(hand);
  const ThingHandle& handle = *task.things[0].handle;
  const ThingMotion& thing = best.things.front();
  const Clip& clip = best.motion.clip;
  int moving = 0;
  std::optional<Vec3d> grip;
  for (int f = 1; f < clip.frames; ++f) {
    const Transformd& pose = thing.poses[static_cast<std::size_t>(f)];
    if (norm(pose.translation - thing.poses[static_cast<std::size_t>(f - 1)].translation) < 1e-5) {
      continue;
    }
    ++moving;
    const Posture posture(task.body, clip.frame(f));
    const Transformd place = posture.place(effector.link);
    const Vec3d own = inverse(pose) * (place * effector.point);
    if (!grip) grip = own;
    EXPECT_LE(norm(own - *grip), kExact);
    EXPECT_LE(norm(own - handle.position), kWithinPalm);
  }
  EXPECT_GT(moving, 10);
}

Thing mug() {
  return {.name = "mug",
          .shape = ThingShape::cylinder,
          .size = {0.08, 0.1, 0.08},
          .mass = 0.4,
          .position = {-0.25, 1.0, 0.4},
          .upright = true,
          .handle = ThingHandle{{-0.07, 0, 0}, {0, 1, 0}}};
}

Thing bucket() {
  return {.name = "bucket",
          .shape = ThingShape::cylinder,
          .size = {0.26, 0.25, 0.26},
          .mass = 5,
          .position = {-0.3, 0.3, 0.35},
          .upright = true,
          .handle = ThingHandle{{0, 0.3, 0}, {1, 0, 0}}};
}

TEST(Handle, AMugIsHeldByItsUprightBar) {
  expect_held_by_the_bar(task_of(mug(), {-0.05, 1.05, 0.45}));
}

TEST(Handle, ABucketIsHeldByItsLevelBar) {
  expect_held_by_the_bar(task_of(bucket(), {-0.25, 0.5, 0.4}));
}

TEST(Handle, ABucketHangsBesideTheLegOfWhoStands) {
  Task task = task_of(bucket(), {});
  task.things[0].position = {-0.3, 0.125, 0.3};
  task.actions = {{.grasp = "bucket"}, {.stand = Stance{}}};
  const auto result = perform(task);
  ASSERT_TRUE(result) << result.error().to_string();
  ASSERT_TRUE(result->meets_goals()) << result->conflict.text;
  const Candidate& best = result->candidates.front();
  const Transformd& end = best.things.front().poses.back();
  EXPECT_GT(end.translation.y, 0.125 + 0.1);
  EXPECT_LT(end.translation.y, 0.6);
  EXPECT_LT(end.translation.x, -0.2);
  const Clip& clip = best.motion.clip;
  const Posture last(task.body, clip.frame(clip.frames - 1));
  const Posture home(task.body, task.home.angles);
  const Effector& hand = task.body.effector(*task.body.find_effector("right_hand"));
  const Vec3d off = last.place(hand.link) * hand.point - home.place(hand.link) * hand.point;
  EXPECT_LT(norm(off), 0.15);
}

TEST(Handle, TheThumbIsAlongTheBarAndThePalmTowardsIt) {
  const PosedBody person = build_character({}).value();
  const Kinematics<double> placed_home = placed(person.body, person.home);
  for (const Thing& thing : {mug(), bucket()}) {
    const Transformd pose = start_pose(thing);
    const Holds holds = holds_of(person.body, placed_home, thing, pose, {}, {});
    ASSERT_FALSE(holds.empty());
    ASSERT_EQ(holds.front().size(), 1u);
    const Goal& goal = holds.front().front();
    ASSERT_TRUE(goal.rotation);
    const Mat3d turn = to_matrix(*goal.rotation);
    EXPECT_NEAR(abs(dot(turn.cz, normalized(thing.handle->along))), 1.0, 1e-9);
    const Vec3d to_bar = pose * thing.handle->position - goal.position;
    EXPECT_NEAR(dot(turn.cx, normalized(to_bar)), goal.effector == "left_hand" ? -1.0 : 1.0, 1e-9);
    EXPECT_LE(norm(to_bar), kWithinPalm);
  }
}

TEST(Handle, OnlyAHeavyThingWithAHandleTakesTwoHands) {
  Thing thing = bucket();
  EXPECT_FALSE(takes_two(thing));
  thing.mass = 30;
  EXPECT_TRUE(takes_two(thing));
  thing.handle.reset();
  thing.mass = 1;
  EXPECT_TRUE(takes_two(thing));
}

}  // namespace
}  // namespace shigusa
