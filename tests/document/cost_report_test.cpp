// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/character.hpp>
#include <shigusa/report.hpp>
#include <shigusa/score.hpp>
#include <string>

namespace shigusa {
namespace {

// A heavy box that is taken from the floor.
Task lift_of(double mass) {
  Task task(build_character({}).value());
  task.seed = 3;
  task.candidates = 1;
  Thing box{.name = "box & <crate>"};
  box.size = {0.3, 0.2, 0.25};
  box.mass = mass;
  box.position = {0.0, 0.1, 0.4};
  task.things = {box};
  task.actions.push_back({.grasp = box.name});
  task.actions.push_back({.place = box.name, .position = Vec3d{0.0, 0.9, 0.4}});
  return task;
}

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(CostReport, TellsALiftAndLoadsNothing) {
  const Task task = lift_of(12.0);
  const GenerateResult result = perform(task).value();
  const Candidate& best = result.candidates.front();
  const MotionCost cost = candidate_cost(task, best, {}).value();
  ASSERT_EQ(cost.lifts.size(), 1U);
  const std::vector<TriedChange> changes{{"half the load", cost_peaks(cost), Verdict::possible}};
  const CostReport report{task, best, cost, {}, changes, {}};
  const std::string html = cost_report(report).value();
  EXPECT_EQ(html, cost_report(report).value());
  for (const std::string_view part :
       {"REBA", "RULA", "L5/S1 compression", "Lifting index", "By action", "half the load",
        "Over time", "NIOSH", "EN 1005-4", "people who could", "no diagnosis"}) {
    EXPECT_NE(html.find(part), html.npos) << part;
  }
  EXPECT_EQ(count_of(html, "<img"), 2U);
  EXPECT_EQ(html.find("src=\"http"), html.npos);
  EXPECT_EQ(html.find("<script"), html.npos);
  EXPECT_EQ(html.find("<crate>"), html.npos);
  EXPECT_EQ(html.find("nan"), html.npos);
}

TEST(CostReport, PeaksAreSharesOfWhereAChangeIsUrgent) {
  CostPeaks peaks{.reba = 11, .rula = 3, .compression = 3200.0, .moment = {}, .lifting = 1.5};
  EXPECT_DOUBLE_EQ(peaks.worst(), 1.0);
  EXPECT_DOUBLE_EQ(peaks.mean(), (1.0 + 3.0 / 7.0 + 0.5 + 0.5) / 4.0);
  peaks.no_load = true;
  EXPECT_GT(peaks.worst(), 1.0);
  EXPECT_EQ(CostPeaks{}.worst(), 0.0);
}

// Half of a heavy load loads the back less; what is tried is sorted by what it gains.
TEST(CostReport, ChangesLowerTheCost) {
  const Task task = lift_of(20.0);
  const GenerateResult result = perform(task).value();
  const Candidate& best = result.candidates.front();
  const CostPeaks now = cost_peaks(candidate_cost(task, best, {}).value());
  const std::vector<TriedChange> tried = try_changes(task, best, {}).value();
  ASSERT_FALSE(tried.empty());
  EXPECT_LE(tried.size(), 3U);
  EXPECT_TRUE(std::is_sorted(tried.begin(), tried.end(), [](const auto& a, const auto& b) {
    return a.peaks.worst() < b.peaks.worst();
  }));
  EXPECT_LT(tried.front().peaks.worst(), now.worst());
  const auto half = std::find_if(tried.begin(), tried.end(), [](const TriedChange& change) {
    return change.change == "half the load";
  });
  ASSERT_NE(half, tried.end());
  EXPECT_LT(*half->peaks.compression, *now.compression);
}

}  // namespace
}  // namespace shigusa
