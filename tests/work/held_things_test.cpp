// SPDX-License-Identifier: MIT
// A held thing counts in the motion: its mass, where that is, and its size.
#include <gtest/gtest.h>

#include <atomic>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

namespace shigusa {
namespace {

// A box is lifted from a low bench to belly height.
Task lifting(const Vec3d& centre) {
  Task task(human_body(), {});
  task.things = {{.name = "box",
                  .size = {0.4, 0.25, 0.3},
                  .mass = 12,
                  .position = {0, 0.5, 0.42},
                  .centre = centre}};
  task.actions = {{.grasp = "box"}, {.place = "box", .position = Vec3d{0, 1.0, 0.42}}};
  return task;
}

Candidate best_of(const Task& task) { return perform(task).value().candidates.front(); }

TEST(HeldThings, MassOffTheMiddleChangesPostureAndVerdict) {
  const Candidate even = best_of(lifting({}));
  const Candidate ahead = best_of(lifting({0, 0, 0.15}));
  const Candidate aside = best_of(lifting({0.15, 0, 0}));
  EXPECT_NE(ahead.motion.clip.angles, even.motion.clip.angles);
  EXPECT_GT(ahead.judgement.reasons.front().amount, even.judgement.reasons.front().amount);
  EXPECT_NE(aside.motion.clip.angles, even.motion.clip.angles);
  EXPECT_GT(aside.judgement.verdict, even.judgement.verdict);
}

// A box of 60 cm is put beyond two posts that reach from the floor to above the head.
Task between_posts(double apart) {
  Task task(human_body(), {});
  const double x = 0.5 * apart + 0.05;
  task.obstacles = {{"left post", {x, 1.1, 0.56}, {}, {0.1, 2.2, 0.1}, 0.0},
                    {"right post", {-x, 1.1, 0.56}, {}, {0.1, 2.2, 0.1}, 0.0}};
  task.things = {{.name = "box", .size = {0.6, 0.2, 0.2}, .mass = 2, .position = {0, 1.0, 0.38}}};
  task.actions = {{.grasp = "box"}, {.place = "box", .position = Vec3d{0, 1.0, 0.7}}};
  return task;
}

TEST(HeldThings, AWideBoxIsNotCarriedBetweenNarrowPosts) {
  const GenerateResult narrow = perform(between_posts(0.5)).value();
  EXPECT_NE(narrow.status, ReachStatus::reached);
  const GenerateResult wide = perform(between_posts(0.9)).value();
  EXPECT_EQ(wide.status, ReachStatus::reached);
}

// High overhead a wrist cannot keep a cup upright.
TEST(HeldThings, WhatTheWristForbidsIsTold) {
  Task task(human_body(), {});
  task.things = {{.name = "cup",
                  .shape = ThingShape::cylinder,
                  .size = {0.08, 0.1, 0.08},
                  .mass = 0.3,
                  .position = {-0.2, 0.9, 0.4},
                  .upright = true}};
  task.actions = {{.grasp = "cup"}, {.place = "cup", .position = Vec3d{-0.2, 2.15, 0.2}}};
  const GenerateResult failed = perform(task).value();
  EXPECT_EQ(failed.status, ReachStatus::unreachable);
  EXPECT_NE(failed.conflict.text.find("cup is to stay upright"), std::string::npos)
      << failed.conflict.text;
}

// A cup between six plates, a centimetre from each of its sides.
TEST(HeldThings, WhatNoHandCanHoldIsTold) {
  Task task(human_body(), {});
  const Vec3d at{-0.2, 0.95, 0.45};
  const Vec3d cup{0.08, 0.1, 0.08};
  task.things = {{.name = "cup", .size = cup, .mass = 0.3, .position = at}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Obstacle plate{.name = "plate", .position = at, .size = {0.2, 0.2, 0.2}};
      plate.position[axis] += side * (0.5 * cup[axis] + 0.011);
      plate.size[axis] = 0.02;
      task.obstacles.push_back(plate);
    }
  }
  task.actions = {{.grasp = "cup"}, {.place = "cup", .position = at + Vec3d{0, 0.3, 0}}};
  const auto refused = perform(task);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().to_string().find("action 1: no hand can hold cup"), std::string::npos)
      << refused.error().to_string();
}

TEST(HeldThings, WorkEndsSoonOnceCancelled) {
  std::atomic<bool> cancel = false;
  int reports = 0;
  double fraction = 0.0;
  Progress progress;
  progress.cancel = &cancel;
  progress.report = [&](const ProgressReport& report) {
    EXPECT_GE(report.fraction, fraction);
    fraction = report.fraction;
    cancel = ++reports > 2;
  };
  const auto ended = perform(lifting({}), progress);
  EXPECT_TRUE(!ended || ended->end == SearchEnd::cancelled);
  EXPECT_LT(fraction, 0.9);
}

}  // namespace
}  // namespace shigusa
