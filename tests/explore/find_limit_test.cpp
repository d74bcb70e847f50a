// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/character.hpp>
#include <shigusa/explore.hpp>

namespace shigusa {
namespace {

Task task_at(const Vec3d& place) {
  Task task(*build_character({}));
  task.goals = {{.effector = "right_hand", .position = place}};
  return task;
}

// Number of the first two seeds for which a task is possible.
int possible(Task task) {
  int count = 0;
  for (int seed = 0; seed < 2; ++seed) {
    task.seed = static_cast<std::uint64_t>(seed);
    const auto made = generate(task);
    count += made->status == ReachStatus::reached &&
             made->candidates.front().judgement.verdict == Verdict::possible;
  }
  return count;
}

TEST(FindLimit, TheHeaviestLoadHoldsWithinAndFailsBeyond) {
  Task task = task_at({-0.2, 1.0, 0.45});
  const auto limit = find_limit(task, {.kind = LimitKind::load, .seeds = 2});
  ASSERT_TRUE(limit) << limit.error().to_string();
  EXPECT_EQ(limit->end, LimitEnd::found);
  task.goals.front().load = (1.0 - kSharpMargin) * limit->value;
  EXPECT_EQ(possible(task), 2);
  task.goals.front().load = (1.0 + kSharpMargin) * limit->value;
  EXPECT_EQ(possible(task) == 0, limit->sharp);
  task.goals.front().load = 1.5 * limit->value;
  EXPECT_EQ(possible(task), 0);
}

TEST(FindLimit, TellsABoundThatHolds) {
  const auto limit =
      find_limit(task_at({-0.2, 1.0, 0.4}), {.kind = LimitKind::load, .bound = 1.0, .seeds = 1});
  ASSERT_TRUE(limit);
  EXPECT_EQ(limit->end, LimitEnd::beyond);
  EXPECT_EQ(limit->value, 1.0);
}

TEST(FindLimit, TellsThatNothingIsPossible) {
  const auto limit =
      find_limit(task_at({-0.2, 1.0, 3.0}), {.kind = LimitKind::highest, .bound = 1.1, .seeds = 1});
  ASSERT_TRUE(limit);
  EXPECT_EQ(limit->end, LimitEnd::nowhere);
  EXPECT_TRUE(limit->out_of_reach);
}

TEST(FindLimit, IsTheSameForAnyNumberOfThreads) {
  Task task = task_at({-0.2, 1.3, 0.4});
  const LimitSettings settings{.kind = LimitKind::highest, .seeds = 1};
  task.batch.threads = 1;
  const auto one = find_limit(task, settings);
  task.batch.threads = 3;
  const auto three = find_limit(task, settings);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->value, three->value);
  EXPECT_EQ(one->trials, three->trials);
}

// A box that is lifted from a table; the second thing is not touched.
Task lift_of_a_box() {
  Task task(*build_character({}));
  task.things = {{.name = "box", .size = {0.4, 0.3, 0.3}, .position = {0.0, 0.75, 0.45}},
                 {.name = "cup", .position = {0.5, 0.05, 0.3}}};
  task.actions = {{.grasp = "box"}};
  return task;
}

TEST(FindLimit, OfAPieceOfWorkIsTheMassOfAThing) {
  Task task = lift_of_a_box();
  const auto limit = find_limit(task, {.bound = 120.0, .seeds = 1});
  ASSERT_TRUE(limit) << limit.error().to_string();
  EXPECT_EQ(limit->end, LimitEnd::found);
  const auto verdict = [&task](double mass) {
    task.things.front().mass = mass;
    return perform(task)->candidates.front().judgement.verdict;
  };
  EXPECT_EQ(verdict((1.0 - kSharpMargin) * limit->value), Verdict::possible);
  EXPECT_NE(verdict(1.5 * limit->value), Verdict::possible);
}

TEST(FindLimit, OfAPieceOfWorkRefusesOtherLimits) {
  const Task task = lift_of_a_box();
  const auto key = [&task](const LimitSettings& settings) {
    return find_limit(task, settings).error().message.key;
  };
  EXPECT_EQ(key({.kind = LimitKind::farthest}), "limit_of_work");
  EXPECT_EQ(key({.thing = "cup"}), "load_no_grasp");
}

TEST(FindLimit, RefusesWhatHasNoLimit) {
  Task task = task_at({-0.2, 1.0, 0.4});
  EXPECT_FALSE(find_limit(task, {.bound = 0.0}));
  EXPECT_FALSE(find_limit(task, {.bound = 501.0}));
  EXPECT_FALSE(find_limit(task, {.seeds = 0}));
  EXPECT_FALSE(find_limit(task, {.kind = LimitKind::highest, .bound = 0.9}));
  task.goals.front().effector = "head";
  EXPECT_EQ(find_limit(task, {}).error().message.key, "load_no_hand");
  task.goals.clear();
  EXPECT_EQ(find_limit(task, {}).error().message.key, "no_goal");
}

}  // namespace
}  // namespace shigusa
