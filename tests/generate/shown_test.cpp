// SPDX-License-Identifier: MIT
// The motions shown to users: several to choose from, on a sensible path, in enough time.
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "generate/approaches.hpp"
#include "generate/candidate.hpp"
#include "generate/distinct.hpp"
#include "problem/make_problem.hpp"

namespace shigusa {
namespace {

constexpr int kUsual = 864;  // motions that are scored where there is a choice

Task task_for(const Vec3d& goal, double load = 0.0) {
  Task task =
      with_preset(Task(human_body(), {.goals = {{.position = goal, .load = load}}}), Preset::flat);
  task.seed = 1;
  return task;
}

// Goals all around a person, with their results.
struct Found {
  Task task;
  GenerateResult result;
};
const std::vector<Found>& found() {
  static const std::vector<Found> all = [] {
    std::vector<Found> results;
    for (std::uint64_t k = 0; k < 60; ++k) {
      Random random(77, k);
      const double x = random.uniform(-0.6, 0.5);
      const double y = random.uniform(0.05, 1.8);
      const Task task = task_for({x, y, random.uniform(-0.3, 0.6)});
      GenerateResult result = generate(task).value();
      if (result.status == ReachStatus::reached) results.push_back({task, std::move(result)});
    }
    return results;
  }();
  return all;
}

// Whether a candidate scores much worse than the first, and is not the best of a style.
bool is_worse(const GenerateResult& result, const Candidate& candidate) {
  const auto style = [](const Candidate& c) { return style_of(c.final_posture.stoop_squat_index); };
  const auto other = [&](const Candidate& c) {
    return c.score.total < candidate.score.total && style(c) == style(candidate);
  };
  return candidate.score.total > result.candidates.front().score.total + kCandidateSpread &&
         std::any_of(result.candidates.begin(), result.candidates.end(), other);
}

TEST(Shown, AreThreeHoweverMuchWorseThatCouldBeMade) {
  int worse = 0;
  for (const auto& [task, result] : found()) {
    for (const Candidate& candidate : result.candidates) {
      if (!is_worse(result, candidate)) continue;
      ++worse;
      EXPECT_TRUE(could_be_made(candidate));
    }
  }
  EXPECT_GE(worse, 1);
  // where few could be made, others are not shown
  const std::vector<Candidate> few = generate(task_for({0.05, 1.15, 0.4})).value().candidates;
  EXPECT_TRUE(std::all_of(few.begin(), few.end(), could_be_made));
}

TEST(Shown, ThatPassThroughTheBodyAreNoMoreThanThree) {
  for (const auto& [task, result] : found()) {
    const std::vector<Candidate>& all = result.candidates;
    if (std::all_of(all.begin(), all.end(), collides)) continue;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!collides(all[i])) continue;
      EXPECT_LT(i, static_cast<std::size_t>(kShownLeast));
    }
  }
  // near the own shoulder some do, after the free ones
  int after = 0;
  for (const double x : {0.0, 0.1, 0.2, 0.3}) {
    for (const double y : {1.1, 1.2, 1.3}) {
      for (const double z : {-0.1, -0.05, 0.05}) {
        const std::vector<Candidate> near = generate(task_for({x, y, z})).value().candidates;
        after += collides(near.back()) && !collides(near.front()) ? 1 : 0;
      }
    }
  }
  EXPECT_GE(after, 1);
}

TEST(Shown, ComeBeforeWhatPassesThroughSomething) {
  Candidate free;
  free.score.total = 2.0;
  Candidate through;
  through.score.total = 1.0;
  through.measures.collides.depth = 0.01;
  EXPECT_TRUE(ranks_of(task_for({}))(free, through));
  EXPECT_FALSE(RanksBefore{}(free, through));
  free.judgement.verdict = Verdict::impossible;
  EXPECT_FALSE(ranks_of(task_for({}))(free, through));
}

TEST(Shown, WhereThereIsNoChoiceTheSearchIsLonger) {
  int longer = 0;
  std::vector<Found> tasks = found();
  for (const double load : {6.0, 8.0, 10.0}) {
    const Task task = task_for({0.4, 0.05, 0.55}, load);
    tasks.push_back({task, generate(task).value()});
  }
  for (const auto& [task, result] : tasks) {
    const std::vector<Candidate>& all = result.candidates;
    const auto could = std::count_if(all.begin(), all.end(), could_be_made);
    const bool chooses = all.front().judgement.verdict == Verdict::possible && could >= 2;
    EXPECT_TRUE(chooses || result.log.evaluations >= 4 * kUsual);
    longer += chooses && result.log.evaluations > kUsual ? 1 : 0;
  }
  EXPECT_GE(longer, 1);
}

TEST(Shown, GoStraightWhereTheDetourStartsWorse) {
  int straight = 0;
  int around = 0;
  for (const auto& [task, result] : found()) {
    const ReachProblem problem = make_problem(task).value();
    const ReachProblem approach = approaches_to_goal(problem, closest_reach(problem)).front();
    if (approach.goals[0].path.detour == Vec3d{}) continue;
    const bool detour = result.candidates.front().goals[0].path == PathKind::detour;
    ++(detour ? around : straight);
  }
  EXPECT_GE(straight, 1);
  EXPECT_GE(around, 1);
  // no tenth better
  const Candidate low = generate(task_for({0.2, 0.15, 0.2})).value().candidates.front();
  EXPECT_EQ(low.goals[0].path, PathKind::detour);
}

// The load is let down in some haste.
TEST(Calmer, IsAFirstChoiceThatStrainsForItsHaste) {
  int calmer = 0;
  for (const double load : {6.0, 9.0, 12.0}) {
    Task task = task_for({-0.4, 0.1, 0.5}, load);
    const GenerateResult result = generate(task).value();
    if (!result.gentled) continue;
    EXPECT_EQ(result.candidates.front().judgement.verdict, Verdict::possible) << load;
    task.duration = result.duration / 1.3;
    const Candidate in_haste = generate(task).value().candidates.front();
    calmer += in_haste.judgement.verdict == Verdict::strains && !in_haste.measures.sudden.jolts();
  }
  EXPECT_GE(calmer, 1);
}

TEST(Calmer, IsNoneThatWouldTakeMuchLongerOrStrainAllTheSame) {
  for (const auto& [goal, load] :
       {std::pair{Vec3d{0.4, 0.05, 0.55}, 16.0}, std::pair{Vec3d{-0.55, 1.25, -0.15}, 16.0}}) {
    const GenerateResult result = generate(task_for(goal, load)).value();
    EXPECT_EQ(result.candidates.front().judgement.verdict, Verdict::strains);
    EXPECT_FALSE(result.gentled);
  }
}

}  // namespace
}  // namespace shigusa
