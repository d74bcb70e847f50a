// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "experiments/goal_search.hpp"
#include "experiments/pagmo_runs.hpp"
#include "experiments/plot.hpp"
#include "experiments/report.hpp"
#include "generate/distinct.hpp"
#include "search/random_search.hpp"
#include "support/bodies.hpp"

namespace shigusa::bench {
namespace {

using namespace testing_support;

SearchProblem sphere() {
  return {.genes = 5,
          .evaluate =
              [](std::span<const double> points, std::span<double> scores) {
                for (std::size_t i = 0; i < scores.size(); ++i) {
                  scores[i] = 0.0;
                  for (const double x : points.subspan(i * 5, 5)) {
                    scores[i] += (x - 0.3) * (x - 0.3);
                  }
                }
              },
          .start = std::vector<double>(5, 0.9)};
}

TEST(BestAt, IsTheBestOfTheFirstPoints) {
  BestAt best({1, 3, 4, 9});
  for (const double score : {0.5, 0.9, 0.4, 0.2, 0.8}) best.note(score);
  EXPECT_EQ(best.best(), (std::vector<double>{0.5, 0.4, 0.2, 0.2}));
}

TEST(BestAt, SeesWhatASearchOfThatBudgetFinds) {
  BestAt best({20, 100});
  (void)random_search(best.watch(sphere()), {.batch = 16, .evaluations = 100, .seed = 3});
  const SearchResult shorter = random_search(sphere(), {.batch = 16, .evaluations = 20, .seed = 3});
  EXPECT_EQ(best.best()[0], shorter.best_seen.score);
}

TEST(Quantile, IsTheNearestOfTheSortedValues) {
  const std::vector<double> values{4.0, 1.0, 3.0, 2.0, 5.0};
  EXPECT_EQ(median(values), 3.0);
  EXPECT_EQ(quantile(values, 0.25), 2.0);
  EXPECT_EQ(quantile(values, 1.0), 5.0);
}

TEST(GoalSearch, ScoresInLanesAsInDouble) {
  const PosedBody body = full_body();
  GoalSearch searched(body, {0.25, 0.55, 0.50});
  const SearchProblem problem = searched.problem();
  double score = 0.0;
  problem.evaluate(problem.start, {&score, 1});
  EXPECT_NEAR(score, searched.replayed(problem.start), kReplayTolerance);
  EXPECT_LT(score, worst_score(searched.criteria()));
}

TEST(RunPagmo, FindsTheSameSideBySideAsAlone) {
  if (pagmo_searches().empty()) GTEST_SKIP() << "built without pagmo";
  std::vector<double> random;
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    random.push_back(random_search(sphere(), {.evaluations = 400, .seed = seed}).best_seen.score);
  }
  for (const std::string& name : pagmo_searches()) {
    SCOPED_TRACE(name);
    const auto alone = run_pagmo(name, sphere(), 1, {50, 400});
    const auto three = run_pagmo(name, sphere(), 3, {50, 400});
    EXPECT_EQ(alone[0], three[0]);
    EXPECT_NE(three[0], three[1]);
    for (const std::vector<double>& run : three) EXPECT_LT(run[1], median(random));
  }
}

TEST(Plot, LinesRunFromAxisToAxisAndStayWithin) {
  const PlotAxis x{"motions", {10, 100, 1000}};
  const PlotAxis y{"score", {1, 10}};
  const std::string svg =
      line_plot(x, y, {{"a", {10, 1000}, {1, 10}}, {"b", {10, 1000}, {50, 50}}});
  // the corners of the drawing, and the upper edge for points above it
  EXPECT_THAT(svg, testing::HasSubstr("x1=\"62.0\" y1=\"344.0\" x2=\"532.0\" y2=\"14.0\""));
  EXPECT_THAT(svg, testing::HasSubstr("x1=\"62.0\" y1=\"14.0\" x2=\"532.0\" y2=\"14.0\""));
}

TEST(Plot, DotsLieOnTheGuideThatTheyFulfil) {
  const PlotAxis axis{"score", {1, 10, 100}};
  const std::string svg = dot_plot(axis, axis, {{"a", {100}, {10}}}, {{"a tenth", 0.1}});
  EXPECT_THAT(svg, testing::HasSubstr("<circle cx=\"532.0\" cy=\"179.0\""));
  EXPECT_THAT(svg, testing::HasSubstr("y1=\"344.0\" x2=\"532.0\" y2=\"179.0\""));
}

}  // namespace
}  // namespace shigusa::bench
