// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <thread>

#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// Reaches by two presets; the third task has a goal for an effector that no body has.
std::vector<Task> tasks_with_a_wrong_one() {
  std::vector<Task> tasks;
  for (const double x : {-0.15, -0.3, 0.0, -0.2}) {
    Task task(half(), {.goals = {{"right_hand", {x, 0.5, 0.5}}}});
    if (tasks.size() == 1) task = with_preset(task, Preset::paper);
    task.evaluations = 60;
    task.seed = tasks.size();
    tasks.push_back(std::move(task));
  }
  tasks[2].goals[0].effector = "tail";
  return tasks;
}

void expect_same(const Result<GenerateResult>& a, const Result<GenerateResult>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) {
    EXPECT_EQ(a.error().to_string(), b.error().to_string());
    return;
  }
  EXPECT_EQ(a->log.evaluations, b->log.evaluations);
  ASSERT_EQ(a->candidates.size(), b->candidates.size());
  for (std::size_t k = 0; k < a->candidates.size(); ++k) {
    const Candidate& ours = a->candidates[k];
    const Candidate& theirs = b->candidates[k];
    EXPECT_EQ(ours.parameters.values, theirs.parameters.values);
    EXPECT_EQ(ours.motion.clip.angles, theirs.motion.clip.angles);
    EXPECT_EQ(ours.motion.torques, theirs.motion.torques);
    EXPECT_EQ(ours.score.total, theirs.score.total);
  }
}

TEST(GenerateAll, GivesWhatGenerateGivesForAnyNumberOfThreads) {
  const std::vector<Task> tasks = tasks_with_a_wrong_one();
  std::vector<Result<GenerateResult>> alone;
  for (const Task& task : tasks) alone.push_back(generate(task));
  for (const int threads : {1, 2, 3, 9}) {
    const auto all = generate_all(tasks, threads);
    ASSERT_EQ(all.size(), tasks.size());
    for (std::size_t k = 0; k < all.size(); ++k) expect_same(all[k], alone[k]);
  }
}

TEST(GenerateAll, LetsAWrongTaskFailAlone) {
  const auto all = generate_all(tasks_with_a_wrong_one());
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k].has_value(), k != 2);
  EXPECT_THAT(all[2].error().to_string(), HasSubstr("unknown effector 'tail'"));
  EXPECT_TRUE(generate_all({}).empty());
}

TEST(GenerateAll, TellsTheProgressOfAllOnTheCallersThread) {
  const std::vector<Task> tasks = tasks_with_a_wrong_one();
  for (const int threads : {1, 2}) {
    std::vector<ProgressReport> reports;
    const Progress progress{.report = [&, caller = std::this_thread::get_id()](const auto& report) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      reports.push_back(report);
    }};
    int evaluations = 0;
    for (const auto& made : generate_all(tasks, threads, progress)) {
      if (made) evaluations += made->log.evaluations;
    }
    ASSERT_FALSE(reports.empty());
    for (std::size_t k = 1; k < reports.size(); ++k) {
      EXPECT_GE(reports[k].fraction, reports[k - 1].fraction);
      EXPECT_LE(reports[k].best_score, reports[k - 1].best_score);
    }
    if (threads > 1) continue;  // the last one to end may be on another thread
    EXPECT_LT(reports.front().fraction, 0.2);
    EXPECT_DOUBLE_EQ(reports.back().fraction, 1.0);
    EXPECT_EQ(reports.back().evaluations, evaluations);
  }
}

TEST(GenerateAll, GivesTheBestSoFarOfWhatHasBegunWhenItIsCancelled) {
  std::vector<Task> tasks = tasks_with_a_wrong_one();
  std::atomic<bool> cancel = false;
  const Progress progress{.report = [&](const ProgressReport&) { cancel = true; },
                          .cancel = &cancel};
  const auto all = generate_all(tasks, 1, progress);
  ASSERT_TRUE(all[0]);
  EXPECT_EQ(all[0]->end, SearchEnd::cancelled);
  EXPECT_FALSE(all[0]->candidates.empty());
  for (std::size_t k = 1; k < all.size(); ++k) {
    ASSERT_FALSE(all[k]);
    EXPECT_EQ(all[k].error().code, ErrorCode::cancelled);
  }
}

TEST(GenerateAll, PassesOnWhatAnOwnCriterionThrows) {
  std::vector<Task> tasks = tasks_with_a_wrong_one();
  tasks[3].criteria.user.push_back(
      {.name = "thrower", .value = [](const BodyModel&, const Motion&) -> double {
         throw std::runtime_error("no value");
       }});
  EXPECT_THROW((void)generate_all(tasks, 2), std::runtime_error);
}

}  // namespace
}  // namespace shigusa
