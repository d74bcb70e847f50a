// SPDX-License-Identifier: MIT
// Goals of feet stay above the floor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/math.hpp>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {
namespace {

using testing::HasSubstr;

Quatd about_x(double angle) {
  const SinCos<double> half = sin_cos(0.5 * angle);
  return {half.sin, 0.0, 0.0, half.cos};
}

// A step of the left foot to `up` (m) above its ankle's start.
Task step_task(double up, bool heels = false) {
  Task task(human_body(BodyBuild{.heels = heels}));
  const int foot = task.body.find_effector("left_foot").value();
  const Kinematics<double> start = home_kinematics(task);
  const Effector& effector = task.body.effector(foot);
  task.goals = {{.effector = "left_foot",
                 .position = start.point(effector.link, effector.point) + Vec3d{0.05, up, 0.15}}};
  return task;
}

std::string refusal(const Task& task) {
  const Result<PreparedTask> made = PreparedTask::of(task);
  return made ? "" : made.error().to_string();
}

TEST(Floor, StepToTheFloorIsTaken) {
  EXPECT_EQ(refusal(step_task(0.0)), "");
  EXPECT_EQ(refusal(step_task(0.0, true)), "");
  EXPECT_EQ(refusal(step_task(-0.0009)), "");
}

TEST(Floor, FootThatWouldEndBelowIsRefusedWithTheLeastHeight) {
  for (const bool heels : {false, true}) {
    const std::string said = refusal(step_task(-0.02, heels));
    EXPECT_THAT(said, HasSubstr("goal of left_foot"));
    EXPECT_THAT(said, HasSubstr("its sole would end 20 mm below the floor"));
  }
  EXPECT_THAT(refusal(step_task(-0.02)), HasSubstr("allowed are 0.068 m and more"));
}

TEST(Floor, TippedFootNeedsMoreHeight) {
  Task task = step_task(0.0);
  task.goals[0].rotation = about_x(radians(40.0));
  EXPECT_THAT(refusal(task), HasSubstr("below the floor"));
  task.goals[0].rotation.reset();
  task.goals[0].axis = GoalAxis{{0, 0, 1}, {0, -1, 0}};
  EXPECT_THAT(refusal(task), HasSubstr("below the floor"));
  task.goals[0].axis = GoalAxis{{0, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(refusal(task), "");
}

TEST(Floor, StepOnTiptoeEndsWithItsToesOnTheFloor) {
  Task task = step_task(0.0);
  task.goals[0].rotation = about_x(radians(30.0));
  double& height = task.goals[0].position.y;
  while (!refusal(task).empty()) height += 1e-3;
  task.evaluations = 30;
  task.candidates = 1;
  const GenerateResult made = generate(task).value();
  ASSERT_TRUE(made.meets_goals());
  const Clip& clip = made.candidates[0].motion.clip;
  Kinematics<double> end(task.body);
  forward_kinematics<double>(task.body, clip.frame(clip.frames - 1), end);
  double lowest = 1.0;
  for (const Foot& foot : task.body.feet()) {
    if (foot.name != "left_foot") continue;
    for (const Vec3d& corner : foot.outline) {
      lowest = min(lowest, end.point(foot.link, corner).y);
    }
  }
  // the search for the height goes by millimetres, and goals are met to one
  EXPECT_GE(lowest, -2e-3);
  EXPECT_LE(lowest, 2e-3);
}

}  // namespace
}  // namespace shigusa
