// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <shigusa/generate.hpp>

#include "generate/layered_approaches.hpp"
#include "problem/make_problem.hpp"
#include "problem/plan_of.hpp"
#include "support/problems.hpp"

// Helpers for tests of presets with layers.
namespace shigusa::testing_support {

// Refers to the task's body.
inline LayeredProblem make_layered_problem(const Task& task) {
  return in_layers(make_problem(task).value(),
                   plan_of(task.body, task.start, task, task.criteria).value());
}

// Converts a candidate's values to the form used by its task's layers, and back.
inline LayeredValues layered_of(const Task& task, const Parameters& parameters) {
  return layered_values(plan_of(task.body, task.start, task, task.criteria).value(), parameters);
}
inline Parameters parameters_of(const Task& task, const LayeredValues& values) {
  return parameters_of(plan_of(task.body, task.start, task, task.criteria).value(), values);
}

// Layers with their parameters, before and after a change by a test.
struct LayeredChange {
  LayeredChange(const PosedBody& body, const std::vector<Goal>& goals, LayerChoice choice = {})
      : list(parameter_list(layers_to_goals(body.body, body.home, goals, choice).value())) {
    after = expected = before = list.start();
  }

  ParameterList list;
  Parameters before{};
  Parameters after{};
  Parameters expected{};
};

// Rules for every motion of a layered task.
inline void expect_layers_kept(const Task& task, const GenerateResult& generation) {
  EXPECT_TRUE(generation.meets_goals()) << task.body.name();
  EXPECT_EQ(generation.remaining_distance, 0.0);
  const ReachProblem problem = make_layered_problem(task).reach;
  ASSERT_FALSE(generation.candidates.empty());
  for (const Candidate& candidate : generation.candidates) {
    const MeasuredMotion measured(problem, candidate.motion.clip);
    EXPECT_TRUE(measured.finite);
    EXPECT_EQ(measured.start_error, 0.0);
    EXPECT_LT(measured.goal_error, 1e-6);
    EXPECT_LT(measured.path_error, kReachTolerance);
    // a foot that is the base does not move, nor does one that the leg is bent from; the closed
    // chain of two legs is kept by steps of IK
    EXPECT_LT(measured.contact_slide, task.body.feet().size() == 1 ? 1e-12 : kReachTolerance);
    EXPECT_LT(measured.contact_tilt, kTiltTolerance);
    EXPECT_EQ(
        candidate.score.total,
        score_motion(task.body, candidate.motion, task.criteria, criteria_context(task)).total);
    ASSERT_EQ(candidate.goals.size(), task.goals.size());
    for (const GoalResult& goal : candidate.goals) EXPECT_LT(goal.error, 1e-6);
    EXPECT_EQ(candidate.contacts.size(), task.body.feet().size());
  }
}

}  // namespace shigusa::testing_support
