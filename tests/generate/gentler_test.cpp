// SPDX-License-Identifier: MIT
// Motions that would jolt in their usual duration.
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "generate/delivery.hpp"
#include "generate/other_durations.hpp"
#include "generate/parameter_space.hpp"
#include "generate/problem_search.hpp"

namespace shigusa {
namespace {

const Task kBothHands(human_body(), {.goals = {{"right_hand", {-0.25, 0.35, 0.45}},
                                               {"left_hand", {0.2, 0.35, 0.45}}}});
constexpr int kMotions = 1000;

// The first motion of random parameters that jolts in the problem's duration, in the form of a
// search's result.
std::optional<GenerateResult> jolting(const Problem& problem) {
  const std::unique_ptr<Planner> planner = make_planner(problem).value();
  const ParameterSpace space(problem.reach, *problem.parameters, GeneCode::natural);
  Random random(1);
  for (int k = 0; k < kMotions; ++k) {
    std::vector<double> point;
    for (int g = 0; g < space.genes(); ++g) point.push_back(random.uniform(0.0, 1.0));
    GenerateResult found;
    found.duration = problem.reach.duration;
    found.candidates.push_back(played(*planner, space.decode(point)));
    tell_status(true, found);
    const Candidate& only = found.candidates.front();
    if (found.status == ReachStatus::reached && only.measures.sudden.jolts()) return found;
  }
  return std::nullopt;
}

TEST(Gentler, TakesLongerWhereTheFirstChoiceWouldJoltAndIsPlayedSoAgain) {
  const auto problem = prepare(kBothHands).value();
  std::optional<GenerateResult> found = jolting(*problem);
  ASSERT_TRUE(found);
  try_gentler(*problem, *found);
  EXPECT_TRUE(found->gentled);
  EXPECT_GE(found->duration, 1.1 * problem->reach.duration);
  EXPECT_LE(found->duration, 1.8 * problem->reach.duration);
  const Candidate& first = found->candidates.front();
  EXPECT_FALSE(first.measures.sudden.jolts());
  const Task longer = played_task(kBothHands, *found);
  const Candidate again = regenerate(longer, first.parameters).value().candidates.front();
  EXPECT_EQ(again.motion.clip.angles, first.motion.clip.angles);
  EXPECT_EQ(again.score.total, first.score.total);
}

TEST(Gentler, LeavesADurationThatIsGiven) {
  const auto usual = prepare(kBothHands).value();
  const auto problem = with_duration(*usual, usual->reach.duration).value();
  std::optional<GenerateResult> found = jolting(*problem);
  ASSERT_TRUE(found);
  try_gentler(*problem, *found);
  EXPECT_FALSE(found->gentled);
  EXPECT_EQ(found->duration, usual->reach.duration);
}

TEST(Gentler, IsOfCriteriaThatGiveJoltsAWeight) {
  Task task = kBothHands;
  EXPECT_TRUE(minds_jolts(task));
  task.criteria[CriterionKind::jolts].weight = 0.0;
  EXPECT_FALSE(minds_jolts(task));
}

}  // namespace
}  // namespace shigusa
