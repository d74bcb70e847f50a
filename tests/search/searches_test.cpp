// SPDX-License-Identifier: MIT
// Rules for all searches; the quality of each has its own test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <map>
#include <set>
#include <shigusa/search.hpp>
#include <stdexcept>
#include <string>

#include "search/test_functions.hpp"
#include "support/refusal.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class AllSearches : public ::testing::TestWithParam<SearchInfo> {
 protected:
  [[nodiscard]] static SearchResult run(const SearchProblem& problem, int evaluations,
                                        std::uint64_t seed = 1, const Progress& progress = {}) {
    return search(GetParam().method, problem, evaluations, seed, progress);
  }

  [[nodiscard]] static bool genetic() { return GetParam().genetic; }
};

INSTANTIATE_TEST_SUITE_P(Each, AllSearches, ::testing::ValuesIn(kSearches),
                         [](const auto& each) { return std::string(each.param.word); });

TEST_P(AllSearches, ScoreTheSamePointsFirstWhateverTheBudget) {
  Record longest;
  (void)run(longest.watch(problem_of(7, rastrigin)), 3001);
  ASSERT_EQ(longest.points.size(), 3001U);
  for (const int budget : {8, 9, 31, 100, 300, 1000, 2999}) {
    Record record;
    const SearchResult result = run(record.watch(problem_of(7, rastrigin)), budget);
    EXPECT_EQ(result.evaluations, budget);
    ASSERT_EQ(record.points.size(), static_cast<std::size_t>(budget));
    EXPECT_TRUE(std::equal(record.points.begin(), record.points.end(), longest.points.begin()))
        << budget;
  }
}

TEST_P(AllSearches, MoreBudgetIsNeverWorse) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    double last = kInfinity;
    for (const int budget : {10, 50, 100, 200, 400, 800, 1600}) {
      const double best = run(problem_of(5, rosenbrock), budget, seed).best_seen.score;
      EXPECT_LE(best, last);
      last = best;
    }
  }
}

TEST_P(AllSearches, SameSeedGivesTheSameResult) {
  const SearchResult a = run(problem_of(6, rastrigin), 700, 5);
  const SearchResult b = run(problem_of(6, rastrigin), 700, 5);
  EXPECT_EQ(a.final_population, b.final_population);
  EXPECT_EQ(a.best_seen, b.best_seen);
  EXPECT_EQ(a.generations, b.generations);
}

TEST_P(AllSearches, ResultOfASeedIsTheSameEverywhere) {
  // written down from one build; the function needs no more than exact operations
  const Function quartic = [](std::span<const double> x) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double d = x[i] - 0.0625 * static_cast<double>(i + 3);
      sum += d * d * (1.0 + d * d) + 0.5 * d * d * x[0];
    }
    return sum;
  };
  const std::map<SearchMethod, double> expected{
      {SearchMethod::paper_ga, 0x1.54d8p-4},
      {SearchMethod::log_ga, 0x1.54d8p-4},
      {SearchMethod::annealing, 0x1.57b7828ea548fp-9},
      {SearchMethod::cma_es, 0x1.9d03614348695p-36},
      {SearchMethod::differential_evolution, 0x1.70ffa247267eap-22},
      {SearchMethod::random, 0x1.468f61ebddc0bp-3}};
  EXPECT_EQ(run(problem_of(8, quartic), 2000, 42).best_seen.score, expected.at(GetParam().method));
}

TEST_P(AllSearches, OtherSeedsGiveOtherResults) {
  std::set<std::vector<double>> best;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    best.insert(run(problem_of(6, rastrigin), 200, seed).best_seen.point);
  }
  EXPECT_EQ(best.size(), 10U);
}

TEST_P(AllSearches, DoNotDependOnHowABatchIsScored) {
  const SearchProblem whole = problem_of(6, rastrigin);
  SearchProblem parted = whole;
  parted.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    for (std::size_t i = scores.size(); i-- > 0;) {
      whole.evaluate(points.subspan(i * 6, 6), scores.subspan(i, 1));
    }
  };
  EXPECT_EQ(run(whole, 500).final_population, run(parted, 500).final_population);
}

TEST_P(AllSearches, StayInTheUnitCube) {
  for (const Function& function : {Function(corner), Function(bowl_beyond)}) {
    Record record;
    (void)run(record.watch(problem_of(5, function)), 1500);
    for (const std::vector<double>& point : record.points) {
      ASSERT_EQ(point.size(), 5U);
      for (const double x : point) ASSERT_TRUE(x >= 0.0 && x <= 1.0) << x;
    }
  }
}

TEST_P(AllSearches, BestSeenIsTheFirstOfTheBestOfAllScored) {
  Record record;
  // a plateau around the optimum: many are equally good
  const Function terraced = [](std::span<const double> x) { return std::floor(9.0 * sphere(x)); };
  const SearchResult result = run(record.watch(problem_of(4, terraced)), 400);
  const auto best = std::min_element(record.scores.begin(), record.scores.end());
  EXPECT_EQ(result.best_seen.score, *best);
  EXPECT_EQ(result.best_seen.point,
            record.points[static_cast<std::size_t>(best - record.scores.begin())]);
}

TEST_P(AllSearches, FinalPopulationHoldsScoredPointsWithTheirScores) {
  for (const int budget : {8, 13, 100, 1000}) {
    Record record;
    const SearchResult result = run(record.watch(problem_of(4, sphere)), budget);
    const std::set<std::vector<double>> scored(record.points.begin(), record.points.end());
    EXPECT_FALSE(result.final_population.empty());
    for (const Individual& individual : result.final_population) {
      EXPECT_TRUE(scored.contains(individual.point));
      EXPECT_EQ(individual.score, sphere(individual.point));
    }
  }
}

TEST_P(AllSearches, BeginAtTheStartUnlessTheyAreGenetic) {
  if (genetic()) return;
  SearchProblem problem = problem_of(3, sphere);
  problem.start = {0.125, 0.0, 1.0};
  Record record;
  (void)run(record.watch(problem), 1);
  EXPECT_EQ(record.points.at(0), problem.start);
}

TEST_P(AllSearches, NaNIsTheWorstAndCounted) {
  const Function holed = [](std::span<const double> x) { return x[0] < 0.5 ? kNaN : sphere(x); };
  Record record;
  const SearchResult result = run(record.watch(problem_of(4, holed)), 600);
  int refused = 0;
  for (const std::vector<double>& point : record.points) refused += point[0] < 0.5 ? 1 : 0;
  EXPECT_GT(refused, 0);
  EXPECT_EQ(result.rejected_nan, refused);
  EXPECT_GE(result.best_seen.point[0], 0.5);
  EXPECT_LT(result.best_seen.score, 0.1);
}

TEST_P(AllSearches, EndWithAPointThoughAllScoresAreNaN) {
  const SearchResult result = run(problem_of(4, [](std::span<const double>) { return kNaN; }), 500);
  EXPECT_EQ(result.rejected_nan, 500);
  EXPECT_EQ(result.best_seen.point.size(), 4U);
  EXPECT_EQ(result.best_seen.score, kInfinity);
}

TEST_P(AllSearches, ScoresLeftUnwrittenAreRejected) {
  const SearchProblem lazy{
      .genes = 3,
      .evaluate = [](std::span<const double>, std::span<double> scores) { scores[0] = 1.0; }};
  const SearchResult result = run(lazy, 100);
  EXPECT_EQ(result.best_seen.score, 1.0);
  EXPECT_GT(result.rejected_nan, 50);
}

TEST_P(AllSearches, BearInfiniteHugeAndEqualScores) {
  const auto best_of = [](Function function) {
    return run(problem_of(3, std::move(function)), 800).best_seen.score;
  };
  EXPECT_EQ(best_of([](std::span<const double>) { return 0.25; }), 0.25);
  EXPECT_EQ(best_of([](std::span<const double>) { return kInfinity; }), kInfinity);
  EXPECT_EQ(best_of([](std::span<const double> x) { return x[0] < 0.5 ? -kInfinity : 1.0; }),
            -kInfinity);
  EXPECT_LT(best_of([](std::span<const double> x) { return 1e300 * sphere(x); }), 1e299);
  EXPECT_LT(best_of([](std::span<const double> x) { return sphere(x) - 1e6; }), 0.1 - 1e6);
}

TEST_P(AllSearches, WorkWithOneGeneAndWithMany) {
  EXPECT_LT(run(problem_of(1, sphere), 200).best_seen.score, 1e-2);
  EXPECT_EQ(run(problem_of(300, sphere), 100).evaluations, 100);
}

TEST_P(AllSearches, ReportGrowingShareOfTheBudget) {
  double fraction = 0.0;
  double best = kInfinity;
  int evaluations = 0;
  const auto report = [&](const ProgressReport& r) {
    EXPECT_GE(r.fraction, fraction);
    EXPECT_LE(r.best_score, best);
    EXPECT_GE(r.evaluations, evaluations);
    fraction = r.fraction;
    best = r.best_score;
    evaluations = r.evaluations;
  };
  const SearchResult result = run(problem_of(5, sphere), 500, 1, {.report = report});
  EXPECT_EQ(fraction, 1.0);
  EXPECT_EQ(best, result.best_seen.score);
  EXPECT_EQ(evaluations, 500);
  EXPECT_EQ(result.end, SearchEnd::budget);
}

TEST_P(AllSearches, CancelledEndWithTheBestSoFar) {
  std::atomic<bool> cancel = false;
  Record record;
  const auto report = [&](const ProgressReport& r) { cancel = r.evaluations > 200; };
  const SearchResult result =
      run(record.watch(problem_of(5, sphere)), 1'000'000, 1, {.report = report, .cancel = &cancel});
  EXPECT_EQ(result.end, SearchEnd::cancelled);
  EXPECT_LT(result.evaluations, 400);
  EXPECT_EQ(result.best_seen.score, *std::min_element(record.scores.begin(), record.scores.end()));
  EXPECT_FALSE(result.final_population.empty());
}

TEST_P(AllSearches, CancelledBeforeTheyBeganStillScoreSomething) {
  const std::atomic<bool> cancel = true;
  const SearchResult result = run(problem_of(5, sphere), 1000, 1, {.cancel = &cancel});
  EXPECT_EQ(result.end, SearchEnd::cancelled);
  EXPECT_GE(result.evaluations, 1);
  EXPECT_LE(result.evaluations, 64);
  EXPECT_EQ(result.best_seen.score, sphere(result.best_seen.point));
}

TEST_P(AllSearches, EndAtTheDeadline) {
  using std::chrono::steady_clock;
  const auto begin = steady_clock::now();
  const auto wait = std::chrono::milliseconds(50);
  const SearchResult result =
      run(problem_of(5, rastrigin), std::numeric_limits<int>::max(), 1, {.deadline = begin + wait});
  const auto took = steady_clock::now() - begin;
  EXPECT_EQ(result.end, SearchEnd::cancelled);
  EXPECT_GE(took, wait);
  // a batch takes microseconds; the rest is room for a busy machine
  EXPECT_LT(took, std::chrono::seconds(5));
}

TEST_P(AllSearches, WhatTheProblemOrTheReportThrowsPassesThrough) {
  const auto broken = [](std::span<const double>) -> double { throw std::runtime_error("no"); };
  EXPECT_THROW((void)run(problem_of(5, broken), 100), std::runtime_error);
  const auto throwing = [](const ProgressReport&) { throw std::runtime_error("no"); };
  EXPECT_THROW((void)run(problem_of(5, sphere), 100, 1, {.report = throwing}), std::runtime_error);
}

TEST_P(AllSearches, RefuseProblemsOutOfRangeAndNameWhy) {
  const auto told = [](const SearchProblem& problem, int evaluations = 100) {
    return refusal([&] { return run(problem, evaluations); });
  };
  for (const int genes : {-1, 0, kMaxGenes + 1}) {
    EXPECT_THAT(told(problem_of(genes, sphere)), HasSubstr("genes is"));
  }
  EXPECT_THAT(told({.genes = 3}), HasSubstr("no evaluate function"));
  SearchProblem problem = problem_of(2, sphere);
  problem.start = {0.5};
  EXPECT_THAT(told(problem), HasSubstr("start has 1 coordinates"));
  for (const double x : {-0.01, 1.01, kNaN}) {
    problem.start = {0.5, x};
    EXPECT_THAT(told(problem), HasSubstr("start has a coordinate of"));
  }
  for (const int budget : {0, -5}) {
    EXPECT_THAT(told(problem_of(2, sphere), budget), HasSubstr("evaluations is"));
  }
}

TEST_P(AllSearches, AreFoundByTheirWords) {
  const SearchMethod method = GetParam().method;
  EXPECT_EQ(value_of<SearchMethod>(word_of(method), "search"), method);
  EXPECT_EQ(info_of(method).method, method);
}

TEST(SearchMethod, WordsAreTheOnesOfTheCommandLine) {
  EXPECT_THAT(all_words<SearchMethod>(),
              ::testing::ElementsAre("paper_ga", "log_ga", "annealing", "cma_es", "de", "random"));
  EXPECT_THAT(value_of<SearchMethod>("cma", "search").error().message,
              HasSubstr("unknown search 'cma'; did you mean 'cma_es'?"));
  EXPECT_FALSE(value_of<SearchMethod>("", "search"));
}

TEST(SearchMethod, TheTwoGeneticOnesAreOneAlgorithm) {
  const SearchProblem problem = problem_of(5, rastrigin);
  EXPECT_EQ(search(SearchMethod::paper_ga, problem, 500, 3).final_population,
            search(SearchMethod::log_ga, problem, 500, 3).final_population);
}

}  // namespace
}  // namespace shigusa
