// SPDX-License-Identifier: MIT
// The preset flat: its parameter space, its archive, and its results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "generate/archive.hpp"
#include "generate/distinct.hpp"
#include "generate/parameter_space.hpp"
#include "plan/held_input.hpp"
#include "problem/make_problem.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::Not;

constexpr Vec3d kAtTheFeet{-0.15, 0.05, 0.45};

Task flat_task(const PosedBody& posed, const Vec3d& goal) {
  return Task(posed, {.goals = {{"right_hand", goal}}});
}

TEST(ParameterSpace, StartsAtThePlainMotion) {
  const Task task = flat_task(full_body(), kAtTheFeet);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  const ParameterSpace space(problem, list, GeneCode::natural);
  const Parameters start = space.decode(space.start());
  const Parameters plain = list.start();
  EXPECT_TRUE(start.posed);
  EXPECT_EQ(start.locked, plain.locked);
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_NEAR(start.values[i], plain.values[i], 1e-12) << list.all[i].name;
  }
  EXPECT_EQ(value_of(list, start, "delay"), 0.0);
}

TEST(ParameterSpace, SearchesOnlyWhatMovesAGoalOrAFoot) {
  const Task task = flat_task(full_body(), kAtTheFeet);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  const std::vector<std::string> names = ParameterSpace(problem, list, GeneCode::natural).names();
  for (const char* name : {"hip.flexion", "knee.flexion", "right_elbow.flexion", "squat", "lean",
                           "twist", "right_swivel", "bow", "sway"}) {
    EXPECT_THAT(names, Contains(name));
  }
  for (const char* name : {"left_elbow.flexion", "left_swivel", "left_knee.flexion"}) {
    EXPECT_THAT(names, Not(Contains(name)));
  }
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(ParameterSpace, PaperCodesAreThePapersWeights) {
  const Task task = flat_task(half_body(), kAtTheFeet);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  const ParameterSpace space(problem, list, GeneCode::paper);
  ASSERT_EQ(space.genes(), 9);
  std::vector<double> point;
  std::vector<std::uint16_t> codes;
  for (const int code : {0, 1, 7, 14, 15, 3, 2, 9, 8}) {
    point.push_back((code + 0.5) / 16.0);
    codes.push_back(static_cast<std::uint16_t>(code));
  }
  EXPECT_EQ(space.decode(point), decode_paper_genes(task.body, codes));
}

TEST(ParameterSpace, DelayAndSkewAreSearchedOnRequestOnly) {
  const Task task = flat_task(full_body(), kAtTheFeet);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  const ParameterSpace natural(problem, list, GeneCode::natural);
  const ParameterSpace every(problem, list, GeneCode::every);
  EXPECT_EQ(every.genes(), natural.genes() + 2);
  for (const char* name : {"delay", "skew"}) {
    EXPECT_LT(natural.find(name), 0) << name;
    EXPECT_GE(every.find(name), 0) << name;
  }
}

TEST(ParameterSpace, RowsAreTheDecodedParametersRounded) {
  const Task task = flat_task(full_body(), kAtTheFeet);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  ParameterSpace space(problem, list, GeneCode::every);
  Random random(2);
  std::vector<double> points;
  for (int k = 0; k < 3 * space.genes(); ++k) points.push_back(random.uniform());
  const MotionInputs rows = space.rows(points);
  const std::size_t dofs = task.body.dofs().size();
  ASSERT_EQ(rows.inverse_weights.size(), 3 * dofs);
  const auto genes = static_cast<std::size_t>(space.genes());
  for (std::size_t i = 0; i < 3; ++i) {
    const Parameters p = space.decode(std::span(points).subspan(i * genes, genes));
    const std::vector<double> change = posture_change(task.body, modes_of(task, p));
    for (std::size_t d = 0; d < dofs; ++d) {
      EXPECT_NEAR(static_cast<double>(rows.inverse_weights[i * dofs + d]) * p.values[d], 1.0, 1e-6);
      EXPECT_NEAR(static_cast<double>(rows.posture[i * dofs + d]), change[d], 1e-6);
    }
    const std::vector<double> timing = list.of_kind(ParameterKind::timing, p);
    for (std::size_t k = 0; k < kTimings; ++k) {
      EXPECT_NEAR(static_cast<double>(rows.timing[kTimings * i + k]), timing[k], 1e-7);
    }
  }
}

TEST(Archive, KeepsTheBestOfEachCellAndDropsWhatMissed) {
  const PosedBody posed = half_body();
  Archive archive(posed, 0);
  const std::size_t dofs = posed.body.dofs().size();
  // the mode's own direction: knees bend under an upright trunk, hips sink with the shoulders
  const std::vector<double> squat = posture_modes(posed)[0].direction;
  std::vector<float> postures(10 * dofs, 0.0F);
  std::vector<double> points;
  std::vector<double> scores;
  for (std::size_t i = 0; i < 10; ++i) {
    points.push_back(0.1 * static_cast<double>(i));
    scores.push_back(i == 3 ? 1.0 : 0.9 - 0.05 * static_cast<double>(i));
    for (std::size_t d = 0; d < dofs; ++d) {
      postures[i * dofs + d] = static_cast<float>((i == 9 ? 2.2 : 0.1) * squat[d]);
    }
  }
  archive.add(points, scores, postures, 1.0);
  const std::vector<Archived> ranked = archive.ranked();
  ASSERT_EQ(ranked.size(), Archive::kPerCell + 1);
  EXPECT_EQ(ranked[0].point[0], points[9]);
  EXPECT_EQ(ranked[0].style, Style::squat);
  for (std::size_t k = 1; k < ranked.size(); ++k) {
    EXPECT_EQ(ranked[k].point[0], points[9 - k]);
    EXPECT_EQ(ranked[k].style, Style::upright);
  }
}

class Flat : public testing::TestWithParam<Vec3d> {};

TEST_P(Flat, CandidatesMeetTheGoalWithinAllLimitsAndLookDifferent) {
  Task task = flat_task(full_body(), GetParam());
  task.duration = 2.0;  // in less time, strength allows less variety
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  ASSERT_GE(generation.candidates.size(), 2U);  // elbows that point inwards are left out
  const ReachProblem problem = make_problem(task).value();
  for (std::size_t i = 0; i < generation.candidates.size(); ++i) {
    const Candidate& candidate = generation.candidates[i];
    EXPECT_LE(candidate.goals[0].error, 1e-3);
    EXPECT_TRUE(candidate.measures.over_limit.empty());
    EXPECT_LE(MeasuredMotion(problem, candidate.motion.clip).contact_slide, 1e-3);
    PostureMeter meter(task.body, task.home, 0);
    const Look look = meter.look(candidate.motion.clip);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(look_alike(meter.look(generation.candidates[k].motion.clip), look, 0.98));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Goals, Flat,
                         testing::Values(Vec3d{0.25, 0.55, 0.5}, kAtTheFeet,
                                         Vec3d{-0.35, 1.9, 0.25}));

// a squat down to the feet is unnatural, and scores far worse
TEST(FlatSearch, AtTheFeetItFindsAStoopAndBentKnees) {
  Task task = flat_task(full_body(), kAtTheFeet);
  task.duration = 3.0;  // enough time for the ankles' strength to lower a body into a squat
  const GenerateResult generation = generate(task).value();
  double least = 100.0;
  double most = 0.0;
  for (const Candidate& candidate : generation.candidates) {
    const double index = candidate.final_posture.stoop_squat_index.value();
    least = std::fmin(least, index);
    most = std::fmax(most, index);
    EXPECT_TRUE(candidate.measures.over_limit.empty());
  }
  EXPECT_LT(least, 0.5 * (kSquatIndex + kStoopIndex) + 5.0);
  EXPECT_GT(most, kStoopIndex);
}

TEST(FlatSearch, SaysWhyThereAreFewerCandidates) {
  Task task = flat_task(full_body(), {0.25, 0.55, 0.5});
  task.seed = 1;
  task.candidates = 3;
  const GenerateResult all = generate(task).value();
  EXPECT_EQ(static_cast<int>(all.candidates.size()), task.candidates);
  EXPECT_EQ(all.fewer, "");
  task.candidates = 500;
  const GenerateResult fewer = generate(task).value();
  EXPECT_LT(fewer.candidates.size(), 500U);
  EXPECT_THAT(fewer.fewer, testing::HasSubstr(std::to_string(fewer.candidates.size()) + " of 500"));
  EXPECT_THAT(fewer.fewer, testing::HasSubstr("look like a better one"));
}

TEST(FlatSearch, BeatsThePapersAlgorithmByThePapersOwnCriteria) {
  Task paper =
      with_preset(Task(full_body(), {.goals = {{"right_hand", kAtTheFeet}}}), Preset::paper);
  paper.evaluations = 3000;
  Task flat = flat_task(full_body(), kAtTheFeet);
  flat.criteria = paper_criteria();
  EXPECT_LT(generate(flat).value().candidates[0].score.total,
            0.8 * generate(paper).value().best_seen_score);
}

TEST(FlatSearch, MoreBudgetIsNeverWorse) {
  double before = 1e9;
  for (const int evaluations : {24, 39, 40, 41, 100, 300, 1000, 2000}) {
    Task task = flat_task(half_body(), kAtTheFeet);
    task.duration = 1.5;  // scores of different durations are no comparison
    task.evaluations = evaluations;
    const double best = generate(task).value().best_seen_score;
    EXPECT_LE(best, before + kReplayTolerance) << evaluations;
    before = best;
  }
}

TEST(FlatSearch, FindsTheSameOnAnyNumberOfThreads) {
  Task task = flat_task(half_body(), kAtTheFeet);
  task.evaluations = 700;
  task.batch.threads = 1;
  const GenerateResult alone = generate(task).value();
  for (const int threads : {2, 5}) {
    task.batch.threads = threads;
    const GenerateResult generation = generate(task).value();
    ASSERT_EQ(generation.candidates.size(), alone.candidates.size());
    for (std::size_t i = 0; i < alone.candidates.size(); ++i) {
      EXPECT_EQ(generation.candidates[i].parameters, alone.candidates[i].parameters);
    }
  }
}

TEST(FlatSearch, NeverScoresMoreThanItsBudget) {
  for (const int evaluations : {8, 9, 23, 24, 39, 40, 41, 100}) {
    Task task = flat_task(half_body(), kAtTheFeet);
    task.evaluations = evaluations;
    // a goal that no way leads to would be searched for on each
    EXPECT_LE(generate(task).value().log.evaluations, 3 * evaluations) << evaluations;
    task.goals[0].position = {-0.25, 1.0, 0.35};
    EXPECT_LE(generate(task).value().log.evaluations, evaluations) << evaluations;
  }
}

TEST(FlatSearch, EverySearchFindsCandidates) {
  for (const auto& [method, word] : kEnumWords<SearchMethod>) {
    Task task = flat_task(half_body(), {-0.2, 0.6, 0.5});
    task.search = method;
    task.evaluations = 300;
    const GenerateResult generation = generate(task).value();
    EXPECT_TRUE(generation.meets_goals()) << word;
    EXPECT_LE(generation.log.evaluations, 300) << word;
    EXPECT_GE(generation.log.evaluations, 290) << word;
  }
}

TEST(FlatSearch, EditedPostureIsCheckedAndPlayed) {
  const Task task = flat_task(full_body(), kAtTheFeet);
  Parameters parameters = uniform_parameters(task.body);
  parameters.posed = true;
  EXPECT_TRUE(regenerate(task, parameters).has_value());
  value_of(task, parameters, "bow") = 1.0;
  EXPECT_FALSE(regenerate(task, parameters).has_value());
  value_of(task, parameters, "bow") = 0.0;
  parameters.values.pop_back();
  EXPECT_FALSE(regenerate(task, parameters).has_value());
}

}  // namespace
}  // namespace shigusa
