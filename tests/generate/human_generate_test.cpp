// SPDX-License-Identifier: MIT
// Motions of the preset human.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "generate/posture_meter.hpp"
#include "problem/make_problem.hpp"
#include "problem/plan_of.hpp"
#include "support/layered.hpp"
#include "support/named_values.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kLowFront{-0.25, 0.6, 0.5};
constexpr Vec3d kAtTheFeet{-0.05, 0.1, 0.3};
constexpr Vec3d kHigh{-0.45, 1.75, 0.35};

Task task_for(const PosedBody& posed, const Vec3d& goal, const char* hand = "right_hand") {
  Task task = with_preset(Task(posed, {.goals = {{hand, goal}}}), Preset::human);
  task.seed = 1;
  task.evaluations = 160;
  return task;
}

GenerateResult generated(const Task& task) { return generate(task).value(); }

// rad, distance of a dof's final angle from its start
double travel(const Task& task, const Candidate& candidate, const char* dof) {
  const auto d = static_cast<std::size_t>(task.body.find_dof(dof).value());
  const Clip& clip = candidate.motion.clip;
  return clip.frame(clip.frames - 1)[d] - clip.frame(0)[d];
}

TEST(GenerateHuman, HandArrivesFeetStayAndLimitsHoldAtRandomGoals) {
  Random random(11);
  int over_limit = 0;
  for (const PosedBody& posed : {half_body(), full_body()}) {
    for (int i = 0; i < 16; ++i) {
      Task task = task_for(posed, near_goal(posed, random));
      task.evaluations = 100;
      task.candidates = 2;
      const GenerateResult generation = generated(task);
      expect_layers_kept(task, generation);
      if (!generation.candidates.front().measures.over_limit.empty()) ++over_limit;
    }
  }
  // goals are on all sides, and some are behind the back, with the trunk in the arm's way
  EXPECT_LE(over_limit, 6);
}

TEST(GenerateHuman, EitherHandAndBothReachLowAndHigh) {
  for (const Vec3d& goal : {kLowFront, kAtTheFeet, kHigh}) {
    const Task task = task_for(full_body(), goal);
    expect_layers_kept(task, generated(task));
  }
  Task task = task_for(full_body(), {0.3, 1.2, 0.35}, "left_hand");
  expect_layers_kept(task, generated(task));
  task.goals.push_back({"right_hand", {-0.2, 1.1, 0.4}});
  const GenerateResult both = generated(task);
  expect_layers_kept(task, both);
  EXPECT_EQ(layered_of(task, both.candidates[0].parameters).swivels.size(), 2u);
  EXPECT_TRUE(layered_of(task, both.candidates[0].parameters).finals.empty());
}

// Its own torque draws it down as the trunk leans.
TEST(GenerateHuman, FreeArmDoesNotStayStiffWhereTheTrunkBends) {
  for (const Vec3d& goal : {kAtTheFeet, Vec3d{0.1, 0.3, 0.5}}) {
    const Task task = task_for(full_body(), goal);
    const Candidate candidate = generated(task).candidates[0];
    EXPECT_GT(abs(travel(task, candidate, "left_shoulder.flexion")) +
                  abs(travel(task, candidate, "left_shoulder.abduction")),
              radians(8.0));
  }
}

// The result for a goal that is low and far in front.
TEST(GenerateHuman, FreeArmIsACounterweightWhereBalanceCounts) {
  Task task = task_for(full_body(), {-0.2, 0.6, 0.7});
  task.duration = make_problem(task)->duration;  // whether it is possible in that or not
  task.criteria = {{CriterionKind::balance, 2.0}, {CriterionKind::joint_range, 0.5}};
  double gained = 0.0;
  for (const Candidate& candidate : generated(task).candidates) {
    LayeredValues stiff = layered_of(task, candidate.parameters);
    stiff.finals = start_values(plan_of(task.body, task.start, task).value()).finals;
    const GenerateResult without = regenerate(task, parameters_of(task, stiff)).value();
    gained = max(gained, without.candidates[0].score.total - candidate.score.total);
  }
  EXPECT_GT(gained, 0.02);
}

TEST(GenerateHuman, FreeArmFollowsAMinimumJerkToItsFinalAngles) {
  const Task task = task_for(full_body(), kLowFront);
  const Candidate candidate = generated(task).candidates[0];
  const std::vector<double> finals = layered_of(task, candidate.parameters).finals;
  const char* const dofs[] = {"left_shoulder.flexion", "left_shoulder.abduction",
                              "left_elbow.flexion"};
  const Clip& clip = candidate.motion.clip;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto d = static_cast<std::size_t>(task.body.find_dof(dofs[k]).value());
    const double start = task.home.angles[d];
    for (int f = 0; f < clip.frames; ++f) {
      const double schedule = minimum_jerk(f / (clip.frames - 1.0));
      EXPECT_NEAR(clip.frame(f)[d], start + (finals[k] - start) * schedule, 1e-12);
    }
  }
}

// The rod of an arm that rises in front of its shoulder is no longer than the hand's distance.
TEST(GenerateHuman, TrunkStaysForWhatTheArmReaches) {
  const Task task = task_for(full_body(), kHigh);
  const Candidate candidate = generated(task).candidates[0];
  EXPECT_LT(abs(travel(task, candidate, "right_knee.flexion")), radians(15.0));
  for (const ScoreTerm& term : candidate.score.terms) {
    if (term.name != "balance_zone") continue;
    EXPECT_LT(term.penalty, 0.05);
  }
}

TEST(GenerateHuman, SameSeedGivesTheSameNumbersOnAnyMachine) {
  Task task = task_for(full_body(), kLowFront);
  task.batch = {SimdSet::scalar, 1};
  const GenerateResult one = generated(task);
  task.batch = {widest_simd_set(), 3};
  const GenerateResult other = generated(task);
  ASSERT_EQ(one.candidates.size(), other.candidates.size());
  for (std::size_t i = 0; i < one.candidates.size(); ++i) {
    EXPECT_EQ(one.candidates[i].parameters, other.candidates[i].parameters);
    EXPECT_EQ(one.candidates[i].motion.clip.angles, other.candidates[i].motion.clip.angles);
    EXPECT_EQ(one.candidates[i].score.total, other.candidates[i].score.total);
  }
}

TEST(GenerateHuman, CandidatesLookDifferentAndAreRanked) {
  Task task = task_for(full_body(), kLowFront);
  task.evaluations = 600;
  task.duration = 2.0;  // in haste, most are worse by far than the best
  const auto candidates = generated(task).candidates;
  ASSERT_GE(candidates.size(), 2u);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    EXPECT_LE(candidates[i - 1].score.total, candidates[i].score.total);
    for (std::size_t k = 0; k < i; ++k) {
      PostureMeter meter(task.body, task.home, 0);
      EXPECT_FALSE(look_alike(meter.look(candidates[k].motion.clip),
                              meter.look(candidates[i].motion.clip), 0.98));
    }
  }
}

TEST(GenerateHuman, GoalsAtTheEdgeOfReachAreMet) {
  for (const Vec3d& goal : {Vec3d{-0.79, 1.81, 0.26}, {0.46, 1.83, 0.64}, {-0.69, 1.63, 0.68}}) {
    const Task task = task_for(half_body(), goal);
    const GenerateResult generation = generated(task);
    EXPECT_LT(generation.remaining_distance, 0.01);
    for (const Candidate& candidate : generation.candidates) {
      EXPECT_EQ(candidate.contacts[0].max_slide, 0.0);
    }
  }
}

TEST(GenerateHuman, GoalOutOfReachIsAStatusWithTheDistanceLeft) {
  const Task task = task_for(full_body(), {-1.5, 1.5, 1.2});
  const GenerateResult generation = generated(task);
  EXPECT_EQ(generation.status, ReachStatus::unreachable);
  EXPECT_GT(generation.remaining_distance, 0.1);
  const auto again = regenerate(task, generation.candidates[0].parameters).value();
  EXPECT_EQ(again.candidates[0].motion.clip.angles, generation.candidates[0].motion.clip.angles);
}

TEST(RegenerateHuman, GivesTheCandidateAgain) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const Task task = task_for(posed, kLowFront);
    const GenerateResult generation = generated(task);
    // motions impossible in their usual duration got a longer one
    const Task played = played_task(task, generation);
    for (const Candidate& candidate : generation.candidates) {
      const GenerateResult again = regenerate(played, candidate.parameters).value();
      EXPECT_EQ(again.candidates[0].motion.clip.angles, candidate.motion.clip.angles);
      EXPECT_EQ(again.candidates[0].score.total, candidate.score.total);
    }
  }
}

TEST(RegenerateHuman, SwivelMovesTheElbowAndNotTheHand) {
  const Task task = task_for(full_body(), {-0.25, 1.2, 0.35});
  const ParameterList list = parameter_list(task.body, task.start, task).value();
  Parameters parameters = generated(task).candidates[0].parameters;
  double last = -10.0;
  for (const double degree : {-40.0, 0.0, 40.0}) {
    value_of(list, parameters, "right_arm.swivel_rad") = radians(degree);
    const GenerateResult edited = regenerate(task, parameters).value();
    EXPECT_TRUE(edited.meets_goals());
    EXPECT_LT(edited.candidates[0].goals[0].error, 1e-8);
    const double elbow = edited.candidates[0].final_posture.elbow_swivel;
    EXPECT_GT(elbow, last + radians(20.0));
    last = elbow;
  }
}

TEST(RegenerateHuman, RefusesWhatIsOutOfRange) {
  const Task task = task_for(half_body(), kLowFront);
  Parameters bad = generated(task).candidates[0].parameters;
  value_of(parameter_list(task.body, task.start, task).value(), bad, "right_arm.swivel_rad") = -2.0;
  EXPECT_THAT(regenerate(task, bad).error().to_string(),
              testing::HasSubstr("right_arm: swivel is -2"));
}

}  // namespace
}  // namespace shigusa
