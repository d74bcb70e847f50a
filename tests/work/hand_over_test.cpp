// SPDX-License-Identifier: MIT
// A thing goes from one hand to the other.
#include <gtest/gtest.h>

#include <shigusa/character.hpp>
#include <shigusa/generate.hpp>

namespace shigusa {
namespace {

Task handed(std::vector<std::string> first, std::vector<std::string> second) {
  Task task(build_character({}).value());
  task.things = {{.name = "cup",
                  .shape = ThingShape::cylinder,
                  .size = {0.07, 0.2, 0.07},
                  .mass = 0.4,
                  .position = {-0.2, 1.0, 0.4}}};
  task.actions = {{.grasp = "cup", .with = std::move(first)},
                  {.goals = {{.effector = "right_hand", .position = {-0.05, 1.1, 0.4}}}},
                  {.grasp = "cup", .with = std::move(second)},
                  {.place = "cup", .position = Vec3d{0.25, 1.0, 0.4}}};
  task.candidates = 1;
  return task;
}

TEST(HandOver, TheOtherHandTakesAThingAndPutsIt) {
  const Task task = handed({"right_hand"}, {"left_hand"});
  const GenerateResult result = perform(task).value();
  ASSERT_TRUE(result.meets_goals()) << result.conflict.text;
  const Candidate& best = result.candidates.front();
  ASSERT_EQ(best.actions.size(), 4U);
  EXPECT_LT(best.actions[3].placed->error, 1e-3);
  ASSERT_EQ(best.hands.size(), 2U);
  const HandUse& left = best.hands[0];
  const HandUse& right = best.hands[1];
  EXPECT_EQ(left.effector, "left_hand");
  EXPECT_EQ(right.effector, "right_hand");
  EXPECT_DOUBLE_EQ(right.end.value(), left.there);
  EXPECT_GT(left.there, best.actions[2].start);
  EXPECT_LT(left.there, best.actions[2].end);
  // the cup waits in the right hand until the left one has it
  const ThingMotion& cup = best.things.front();
  const double frame = best.motion.clip.frame_time;
  const auto at = [&](double time) {
    return cup.poses[static_cast<std::size_t>(time / frame + 0.5)].translation;
  };
  for (double time = best.actions[2].start; time <= left.there; time += frame) {
    EXPECT_LT(norm(at(time) - at(left.there)), 1e-3) << time;
  }
}

TEST(HandOver, OnlyAnEmptyHandTakesWhatOneHandHolds) {
  EXPECT_FALSE(perform(handed({"right_hand"}, {"right_hand"})));
  EXPECT_FALSE(perform(handed({"right_hand"}, {})));
  EXPECT_FALSE(perform(handed({"right_hand"}, {"left_hand", "right_hand"})));
  EXPECT_FALSE(perform(handed({}, {"left_hand"})));
}

}  // namespace
}  // namespace shigusa
