// SPDX-License-Identifier: MIT
#include "generate/pareto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/shigusa.hpp>

namespace shigusa {
namespace {

Task pareto_task() {
  Task task(full_body(), {.goals = {{"right_hand", {-0.05, 0.1, 0.3}}}});
  task.criteria = pareto_criteria();
  task.pareto = true;
  return task;
}

Candidate scored(std::initializer_list<double> penalties) {
  Candidate candidate;
  for (const double penalty : penalties) {
    candidate.score.terms.push_back({"", 1.0, penalty});
    candidate.score.total += penalty;
  }
  return candidate;
}

std::vector<double> totals(const std::vector<Candidate>& candidates) {
  std::vector<double> all;
  for (const Candidate& candidate : candidates) all.push_back(candidate.score.total);
  return all;
}

bool dominates(const Candidate& a, const Candidate& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.score.terms.size(); ++k) {
    if (a.score.terms[k].penalty > b.score.terms[k].penalty) return false;
    better = better || a.score.terms[k].penalty < b.score.terms[k].penalty;
  }
  return better;
}

TEST(ParetoFront, LeavesOutWhatAnotherIsBetterThan) {
  const std::vector<Candidate> front =
      not_dominated({scored({0.1, 0.9}), scored({0.9, 0.1}), scored({0.5, 0.5}), scored({0.5, 0.6}),
                     scored({0.9, 0.9})});
  EXPECT_THAT(totals(front), testing::ElementsAre(1.0, 1.0, 1.0));
}

TEST(ParetoFront, KeepsEquals) {
  EXPECT_EQ(not_dominated({scored({0.2, 0.4}), scored({0.2, 0.4})}).size(), 2U);
}

TEST(ParetoFront, SpreadTakesTheEndsAndThenTheFarthest) {
  const std::vector<Candidate> chosen = spread_over(
      {scored({0.0, 1.0}), scored({0.1, 0.95}), scored({0.45, 0.5}), scored({0.95, 0.0})}, 3);
  EXPECT_THAT(totals(chosen), testing::ElementsAre(0.95, 0.95, 1.0));
  EXPECT_EQ(spread_over({}, 3).size(), 0U);
  EXPECT_EQ(spread_over({scored({0.5, 0.5})}, 3).size(), 1U);
}

TEST(ParetoMixtures, AreTheCriteriaAloneInPairsAndTogether) {
  const std::vector<CriteriaSettings> mixtures = pareto_mixtures(pareto_criteria());
  ASSERT_EQ(mixtures.size(), 7U);
  EXPECT_EQ(mixtures[0][CriterionKind::torque].weight,
            pareto_criteria()[CriterionKind::torque].weight);
  double sum = 0.0;
  for (const CriteriaSettings& mixture : mixtures) {
    EXPECT_NEAR(worst_score(mixture), 1.0, 1e-12);
    sum += mixture[CriterionKind::torque].weight;
  }
  EXPECT_NEAR(sum, 1.0 / 3.0 + 1.0 + 0.5 + 0.5, 1e-12);
  // of more than three no pairs
  CriteriaSettings four = pareto_criteria();
  four[CriterionKind::head].weight = 0.25;
  EXPECT_EQ(pareto_mixtures(four).size(), 5U);
  EXPECT_EQ(pareto_mixtures({{CriterionKind::discomfort, 1.0}}).size(), 1U);
}

TEST(Pareto, CandidatesTradeTheCriteriaAndMeetTheGoalWithinLimits) {
  const Task task = pareto_task();
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  ASSERT_GE(generation.candidates.size(), 3U);
  for (const Candidate& a : generation.candidates) {
    EXPECT_LE(a.goals[0].error, kReachTolerance);
    EXPECT_TRUE(a.measures.over_limit.empty());
    for (const Candidate& b : generation.candidates) EXPECT_FALSE(dominates(a, b));
  }
}

// The front reaches about as far along each criterion as one search by the mixture, or farther.
TEST(Pareto, EachCriterionIsBetterSomewhereThanByTheMixtureAlone) {
  Task task = pareto_task();
  task.evaluations = 7 * 1500;
  const GenerateResult front = generate(task).value();
  task.pareto = false;
  task.evaluations = 600;
  const Candidate mixed = generate(task).value().candidates.front();
  for (std::size_t k = 0; k < mixed.score.terms.size(); ++k) {
    double best = 1.0;
    for (const Candidate& c : front.candidates) {
      best = std::min(best, c.score.terms[k].penalty);
    }
    EXPECT_LE(best, mixed.score.terms[k].penalty + 0.05) << mixed.score.terms[k].name;
  }
}

TEST(Pareto, IsOfThePresetFlatOnly) {
  Task task = with_preset(pareto_task(), Preset::paper);
  EXPECT_THAT(generate(task).error().message, testing::HasSubstr("flat does"));
  task = with_preset(pareto_task(), Preset::layers);
  EXPECT_FALSE(generate(task));
}

TEST(NlpGenerator, MotionsMeetTheGoalWithinLimits) {
  Task task(full_body(), {.goals = {{"right_hand", {-0.05, 0.1, 0.3}}}});
  task.generator = MotionGenerator::nlp_ik;
  task.evaluations = 60;
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  EXPECT_EQ(generation.log.evaluations, 60);
  EXPECT_EQ(generation.log.replay_difference, 0.0);
  for (const Candidate& candidate : generation.candidates) {
    EXPECT_LE(candidate.goals[0].error, kReachTolerance);
    EXPECT_TRUE(candidate.measures.over_limit.empty());
    const GenerateResult again =
        regenerate(played_task(task, generation), candidate.parameters).value();
    EXPECT_EQ(again.candidates[0].score.total, candidate.score.total);
  }
  task.batch.threads = 1;
  EXPECT_EQ(generate(task).value().best_seen_score, generation.best_seen_score);
}

}  // namespace
}  // namespace shigusa
