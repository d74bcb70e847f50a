// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "generate/layered_approaches.hpp"
#include "generate/layered_search.hpp"
#include "support/layered.hpp"

namespace shigusa {
namespace {

// Random upper motions of a layered task.
struct Layered {
  Layered(const PosedBody& body, Preset preset, std::vector<Goal> goals, int motions)
      : task(with_preset(Task(body, {.goals = std::move(goals)}), preset)),
        problem(testing_support::make_layered_problem(task)) {
    Random random(6);
    const std::vector<std::size_t> genes = searched_genes(problem);
    for (int i = 0; i < motions; ++i) {
      std::vector<double> point;
      for (std::size_t k = 0; k < genes.size(); ++k) point.push_back(random.uniform(0.2, 0.8));
      uppers.push_back(decode_searched(problem, genes, point, false));
    }
  }
  Layered(const Layered&) = delete;

  struct Scores {
    std::vector<double> scores;
    std::vector<float> ends;
  };
  [[nodiscard]] Scores scored(const CriteriaSettings& criteria, const BatchSettings& batch) const {
    Scores found{std::vector<double>(uppers.size()),
                 std::vector<float>(uppers.size() * task.body.dofs().size())};
    LayeredScorer scorer(problem, criteria, batch, {});
    scorer.score(uppers, found.scores, found.ends);
    return found;
  }

  Task task;
  LayeredProblem problem;
  std::vector<LayeredValues> uppers;
};

// A user's criterion of weight 0 makes motions be scored one by one, in double precision.
CriteriaSettings in_double(CriteriaSettings criteria) {
  criteria.user.push_back(
      {.name = "nothing", .weight = 0.0, .scale = 1.0, .value = [](const auto&, const auto&) {
         return 0.0;
       }});
  return criteria;
}

std::vector<Goal> turning_goal() {
  Goal goal{"right_hand", {-0.2, 1.0, 0.45}};
  goal.axis = GoalAxis{{1, 0, 0}, {0, 1, 0}};
  return {goal};
}

class LayeredScores : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] static Layered made(int number) {
    switch (number) {
      case 0:
        return {half_body(), Preset::layers, {{"right_hand", {-0.15, 0.5, 0.5}}}, 21};
      case 1:
        return {full_body(), Preset::human, {{"right_hand", {-0.15, 0.7, 0.5}}}, 21};
      case 2:
        return {human_body(), Preset::human, {{"left_hand", {0.3, 0.45, 0.4}}}, 21};
      case 3:
        return {human_body(), Preset::human, turning_goal(), 21};
      default:
        return {human_body(),
                Preset::layers,
                {{"left_hand", {0.2, 0.9, 0.45}}, {"right_hand", {-0.2, 1.1, 0.4}}},
                21};
    }
  }
};

TEST_P(LayeredScores, AreThoseOfDoublePrecision) {
  const Layered layered = made(GetParam());
  const CriteriaSettings& criteria = layered.problem.layers[0].criteria;
  const auto lanes = layered.scored(criteria, {SimdSet::lanes_4, 1});
  const auto exact = layered.scored(in_double(criteria), {SimdSet::lanes_4, 1});
  const double worst = worst_score(criteria);
  int arrived = 0;
  std::vector<std::pair<double, double>> differing;
  for (std::size_t i = 0; i < exact.scores.size(); ++i) {
    if (!(exact.scores[i] < worst) || !(lanes.scores[i] < worst)) {
      if ((exact.scores[i] < worst) == (lanes.scores[i] < worst)) continue;
    } else {
      ++arrived;
      if (abs(lanes.scores[i] - exact.scores[i]) <= 0.03 * exact.scores[i]) continue;
    }
    differing.emplace_back(lanes.scores[i], exact.scores[i]);
  }
  EXPECT_GE(arrived, 5);
  // at times another swivel is as good
  EXPECT_LE(differing.size(), 2u) << testing::PrintToString(differing);
}

TEST_P(LayeredScores, AreTheSameBytesInAllSets) {
  const Layered layered = made(GetParam());
  const CriteriaSettings& criteria = layered.problem.layers[0].criteria;
  const auto first = layered.scored(criteria, {SimdSet::scalar, 1});
  for (const SimdSet simd : usable_simd_sets()) {
    for (const int threads : {1, 3}) {
      const auto other = layered.scored(criteria, {simd, threads});
      EXPECT_EQ(other.scores, first.scores) << simd_name(simd);
      EXPECT_EQ(other.ends, first.ends) << simd_name(simd);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plans, LayeredScores, testing::Range(0, 5));

}  // namespace
}  // namespace shigusa
