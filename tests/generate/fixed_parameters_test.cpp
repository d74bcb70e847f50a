// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/files.hpp>
#include <shigusa/shigusa.hpp>

#include "generate/distinct.hpp"
#include "generate/parameter_space.hpp"
#include "plan/assignment.hpp"
#include "problem/make_problem.hpp"
#include "support/named_values.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

const Vec3d kAtTheFeet{-0.05, 0.1, 0.3};

Task fixed_task(Preset preset, const std::vector<const char*>& assignments) {
  Task task = with_preset(Task(full_body(), {.goals = {{"right_hand", kAtTheFeet}}}), preset);
  task.evaluations = 600;
  const ParameterList list = list_of(task);
  task.fixed = no_fixed_parameters(list);
  for (const char* assignment : assignments) {
    EXPECT_TRUE(fix_parameter(list, assignment, *task.fixed)) << assignment;
  }
  return task;
}

class Fixed : public testing::TestWithParam<Preset> {};

TEST_P(Fixed, ParametersAreThoseOfEveryCandidateAndOthersAreNot) {
  const Task task = fixed_task(
      GetParam(), {"right_shoulder.weight=7", "left_knee.locked=true", "twist_deg=10", "bow=0.05"});
  const auto dof = [&](const char* name) {
    return static_cast<std::size_t>(task.body.find_dof(name).value());
  };
  const GenerateResult generation = generate(task).value();
  ASSERT_GE(generation.candidates.size(), 1U);
  for (const Candidate& candidate : generation.candidates) {
    for (const char* name :
         {"right_shoulder.flexion", "right_shoulder.abduction", "right_shoulder.rotation"}) {
      EXPECT_EQ(candidate.parameters.values[dof(name)], 7.0) << name;
      EXPECT_FALSE(candidate.parameters.locked[dof(name)]) << name;
    }
    EXPECT_TRUE(candidate.parameters.locked[dof("left_knee.flexion")]);
    EXPECT_EQ(value_of(task, candidate.parameters, "twist"), radians(10.0));
    EXPECT_EQ(value_of(task, candidate.parameters, "bow"), 0.05);
    // a locked joint keeps its start angle
    const Clip& clip = candidate.motion.clip;
    const std::size_t knee = dof("left_knee.flexion");
    EXPECT_NEAR(clip.frame(clip.frames - 1)[knee], task.home.angles[knee], 1e-3);
  }
  for (std::size_t k = 1; k < generation.candidates.size(); ++k) {
    EXPECT_NE(generation.candidates[0].parameters, generation.candidates[k].parameters);
  }
}

TEST_P(Fixed, MotionsAreThoseThatTheParametersGive) {
  const Task task = fixed_task(GetParam(), {"squat_deg=60", "right_elbow.weight=3"});
  const GenerateResult generation = generate(task).value();
  EXPECT_LT(generation.log.replay_difference, kReplayTolerance);
  const Candidate& best = generation.candidates.front();
  const GenerateResult again = regenerate(played_task(task, generation), best.parameters).value();
  EXPECT_NEAR(again.candidates[0].score.total, best.score.total, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Preset, Fixed, testing::Values(Preset::paper, Preset::flat),
                         [](const auto& of) { return std::string(word_of(of.param)); });

TEST(SquatTarget, IsTheKneesFlexionAtTheEnd) {
  for (const double target : {10.0, 60.0, 100.0}) {
    const std::string text = "squat_deg=" + std::to_string(target);
    Task task = fixed_task(Preset::flat, {text.c_str()});
    task.evaluations = 3000;
    const double start =
        task.home.angles[static_cast<std::size_t>(*task.body.find_dof("right_knee.flexion"))];
    const GenerateResult generation = generate(task).value();
    for (const Candidate& candidate : generation.candidates) {
      EXPECT_NEAR(degrees(candidate.final_posture.knee_flexion - start), target, 13.0);
    }
  }
}

TEST(FixedParameters, AreNoCoordinatesOfTheSearch) {
  const Task task = fixed_task(Preset::flat, {"squat_deg=60", "right_elbow.weight=3"});
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = list_of(task);
  const ParameterSpace all(problem, list, GeneCode::natural);
  const ParameterSpace rest(problem, list, GeneCode::natural, task.fixed);
  EXPECT_EQ(rest.genes(), all.genes() - 2);
  EXPECT_GE(all.find("squat"), 0);
  EXPECT_EQ(rest.find("squat"), -1);
  EXPECT_EQ(rest.find("right_elbow.flexion"), -1);
}

TEST(FixedParameters, AllOfThemLeaveNothingToSearch) {
  Task task = fixed_task(Preset::flat, {});
  task.fixed->set.assign(task.fixed->set.size(), true);
  const Result<GenerateResult> generation = generate(task);
  ASSERT_FALSE(generation);
  EXPECT_THAT(generation.error().message, testing::HasSubstr("every parameter is fixed"));
}

TEST(FixedParameters, OfAnotherBodyAreRefused) {
  Task task = fixed_task(Preset::flat, {});
  task.fixed = no_fixed_parameters(list_of(half_body()));
  EXPECT_FALSE(generate(task));
  task.fixed = no_fixed_parameters(list_of(task));
  task.fixed->set.pop_back();
  EXPECT_FALSE(generate(task));
}

}  // namespace
}  // namespace shigusa
