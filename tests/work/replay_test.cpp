// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

namespace shigusa {
namespace {

// From the floor up over the head, and across: a rise and a way around the body.
GenerateResult reaches(Task& task) {
  for (const Vec3d& place : {Vec3d{-0.2, 0.25, 0.45}, {-0.3, 1.6, 0.3}, {0.45, 1.0, 0.05}}) {
    task.actions.push_back({.goals = {{"right_hand", place}}});
  }
  task.candidates = 2;
  return perform(task).value();
}

TEST(WorkReplay, KeepsTheApproachOfEachMotion) {
  Task task(human_body());
  const Candidate made = reaches(task).candidates.front();
  ASSERT_EQ(made.motions.size(), 3U);
  EXPECT_GT(made.motions[1].approach, 0);  // it stands up in a way of its own
  const GenerateResult again = perform_again(task, made.motions).value();
  EXPECT_EQ(again.candidates.front().motion.clip.angles, made.motion.clip.angles);
}

TEST(WorkReplay, AnApproachThatIsNotThereIsChosenAnew) {
  Task task(human_body());
  const Candidate made = reaches(task).candidates.front();
  for (const int wrong : {-1, 4, 77}) {
    std::vector<WorkMotion> motions = made.motions;
    for (WorkMotion& motion : motions) motion.approach = wrong;
    // 4 is of a rise that not every motion has
    const GenerateResult again = perform_again(task, motions).value();
    EXPECT_TRUE(again.meets_goals()) << wrong;
    if (wrong == 4) continue;
    EXPECT_EQ(again.candidates.front().motion.clip.angles, made.motion.clip.angles) << wrong;
  }
}

}  // namespace
}  // namespace shigusa
