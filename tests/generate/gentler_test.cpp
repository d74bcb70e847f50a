// SPDX-License-Identifier: MIT
// Tasks whose first choice would jolt in their usual time.
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>

#include "core/index.hpp"
#include "support/random_tasks.hpp"
#include "task/make_problem.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr int kTasks = 200;

// The first random task that takes longer so as not to jolt.
std::optional<Task> hasty_task() {
  for (int k = 0; k < kTasks; ++k) {
    if (task_kind(static_cast<std::uint64_t>(k)) != TaskKind::both_hands) continue;
    TaskFile file = random_task(static_cast<std::uint64_t>(k));
    file.character.source = "human";
    adopt_preset(file, Preset::flat);
    Task task = make_task(file, {}).value();
    if (!task.duration && generate(task).value().gentled) return task;
  }
  return std::nullopt;
}

TEST(Gentler, TakesLongerWhereTheFirstChoiceWouldJoltAndIsPlayedSoAgain) {
  const std::optional<Task> task = hasty_task();
  ASSERT_TRUE(task);
  const GenerateResult found = generate(*task).value();
  const double usual = make_problem(*task).value().duration;
  EXPECT_GE(found.duration, 1.1 * usual);
  EXPECT_LE(found.duration, 1.8 * usual);
  const Candidate& first = found.candidates.front();
  EXPECT_FALSE(first.measures.sudden.jolts());
  const Task played = played_task(*task, found);
  const Candidate again = regenerate(played, first.parameters).value().candidates.front();
  EXPECT_EQ(again.motion.clip.angles, first.motion.clip.angles);
  EXPECT_EQ(again.score.total, first.score.total);
  const bool fewer = found.candidates.size() < index(task->candidates);
  EXPECT_EQ(fewer, !found.fewer.empty());
}

TEST(Gentler, LeavesADurationThatIsGiven) {
  Task task = hasty_task().value();
  task.duration = make_problem(task).value().duration;
  const GenerateResult found = generate(task).value();
  EXPECT_FALSE(found.gentled);
  EXPECT_EQ(found.duration, *task.duration);
}

TEST(Gentler, IsOfCriteriaThatGiveJoltsAWeight) {
  Task task = hasty_task().value();
  task.criteria.jolts_weight = 0.0;
  EXPECT_FALSE(generate(task).value().gentled);
}

}  // namespace
}  // namespace shigusa
