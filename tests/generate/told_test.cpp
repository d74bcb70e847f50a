// SPDX-License-Identifier: MIT
// Messages about goals that are not met, or met only by impossible motions: the conflicting goal,
// and the sufficient duration.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

namespace shigusa {
namespace {

using testing::HasSubstr;

Task reaching(std::vector<Goal> goals) {
  return with_preset(Task(human_body(), {.goals = std::move(goals)}), Preset::flat);
}

std::string conflict(std::vector<Goal> goals) {
  Task task = reaching(std::move(goals));
  task.evaluations = 50;
  return generate(task).value().conflict.text;
}

TEST(Conflict, IsTheOneGoalWithoutWhichTheOthersAreInReach) {
  const Goal hand{"right_hand", {-0.3, 1.0, 0.4}};
  EXPECT_THAT(conflict({hand, {"right_elbow", {0.8, 1.9, -0.3}}}), HasSubstr("of right_elbow is"));
  EXPECT_THAT(conflict({{"left_hand", {0.2, 2.6, 0.4}}, hand}), HasSubstr("of left_hand is"));
  EXPECT_THAT(conflict({{"hips", {0.0, 0.3, 0.0}}, {"right_hand", {-0.2, 1.9, 0.2}}}),
              HasSubstr("of hips is"));
}

TEST(Conflict, IsEachOfTwoGoalsThatAreTooFarFromEachOther) {
  EXPECT_THAT(conflict({{"right_hand", {-0.9, 1.0, 0.4}}, {"left_hand", {0.9, 1.0, 0.4}}}),
              HasSubstr("that of right_hand or left_hand"));
}

TEST(Conflict, IsNoneWhereAllIsInReachOrNothingIs) {
  EXPECT_EQ(conflict({{"right_hand", {-0.3, 1.0, 0.4}}, {"left_hand", {0.3, 1.0, 0.4}}}), "");
  EXPECT_EQ(conflict({{"right_hand", {-3.0, 1.0, 0.4}}, {"left_hand", {3.0, 1.0, 0.4}}}), "");
  EXPECT_EQ(conflict({{"right_hand", {-3.0, 1.0, 0.4}}}), "");
}

// The duration reported for a task with too short a one; empty if none is.
std::optional<double> told_time(const GenerateResult& result) {
  for (const Candidate& candidate : result.candidates) {
    if (candidate.judgement.possible_in) return candidate.judgement.possible_in;
  }
  return std::nullopt;
}

class PossibleIn : public testing::TestWithParam<Preset> {};

TEST_P(PossibleIn, IsEnoughWhenItIsAskedFor) {
  int told = 0;
  for (std::uint64_t k = 0; k < 24; ++k) {
    Random random(5, k);
    Task task = with_preset(reaching({{"right_hand",
                                       {random.uniform(-0.6, 0.1), random.uniform(0.1, 1.7),
                                        random.uniform(0.1, 0.6)}}}),
                            GetParam());
    task.duration = random.uniform(0.2, 0.45);
    const GenerateResult hasty = generate(task).value();
    if (hasty.status != ReachStatus::unsteady) continue;
    task.duration = told_time(hasty);
    if (!task.duration) continue;
    ++told;
    EXPECT_NEAR(10.0 * *task.duration, std::round(10.0 * *task.duration), 1e-9);
    EXPECT_EQ(generate(task).value().status, ReachStatus::reached) << "goal " << k;
  }
  EXPECT_GE(told, 1);
}

INSTANTIATE_TEST_SUITE_P(Preset, PossibleIn, testing::Values(Preset::flat, Preset::human),
                         [](const auto& of) { return std::string(word_of(of.param)); });

}  // namespace
}  // namespace shigusa
