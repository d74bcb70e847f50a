// SPDX-License-Identifier: MIT
// Searches over parameters that change once during a motion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <shigusa/generate.hpp>
#include <shigusa/human_body.hpp>
#include <shigusa/result_file.hpp>

#include "generate/parameter_space.hpp"
#include "layers/assignment.hpp"
#include "rollout/held_input.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"
#include "task/make_problem.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::HasSubstr;

constexpr Vec3d kAtTheFeet{-0.15, 0.05, 0.45};

Task two_phases(const std::vector<const char*>& fixed = {}) {
  Task task(full_body(), {.goals = {{"right_hand", kAtTheFeet}}});
  task.phases = 2;
  if (fixed.empty()) return task;
  task.fixed = no_fixed_parameters(task.body);
  for (const char* assignment : fixed) {
    EXPECT_TRUE(fix_parameter(whole_body_plan(task.body), assignment, *task.fixed)) << assignment;
  }
  return task;
}

std::string message(const Task& task) {
  const Result<GenerateResult> generation = generate(task);
  return generation ? "" : generation.error().message;
}

TEST(TwoPhaseSpace, HasWeightsAndModesOnceMoreAndTheSwitch) {
  const Task task = two_phases();
  const ReachProblem problem = make_problem(task).value();
  const ParameterSpace one(problem, GeneCode::natural);
  const ParameterSpace two(problem, GeneCode::natural, {}, 2);
  const std::vector<std::string> names = two.names();
  int phased = 0;
  for (const std::string& name : one.names()) {
    const bool shared = name == "bow" || name == "sway";
    EXPECT_EQ(two.find("later." + name) >= 0, !shared) << name;
    EXPECT_GE(two.find(name), 0) << name;
    phased += shared ? 0 : 1;
  }
  EXPECT_EQ(names.back(), "switch");
  EXPECT_EQ(two.genes(), one.genes() + phased + 1);
}

TEST(TwoPhaseSpace, StartsWithBothPhasesAlike) {
  const Task task = two_phases();
  const ReachProblem problem = make_problem(task).value();
  const ParameterSpace space(problem, GeneCode::natural, {}, 2);
  const Parameters start = space.decode(space.start());
  EXPECT_EQ(start.later->joints, start.joints);
  EXPECT_EQ(start.later->modes, start.posture.modes);
  EXPECT_NEAR(start.later->switch_at, 0.5, 1e-15);
}

TEST(TwoPhaseSpace, RowsAreTheDecodedParametersRounded) {
  const Task task =
      two_phases({"later.squat_deg=30", "left_hip.weight=2", "later.right_elbow.locked=true"});
  const ReachProblem problem = make_problem(task).value();
  ParameterSpace space(problem, GeneCode::natural, task.fixed, 2);
  Random random(2);
  std::vector<double> points;
  for (int k = 0; k < 3 * space.genes(); ++k) points.push_back(random.uniform());
  const MotionInputs rows = space.rows(points);
  const std::size_t dofs = task.body.dofs().size();
  const auto genes = static_cast<std::size_t>(space.genes());
  for (std::size_t i = 0; i < 3; ++i) {
    const Parameters p = space.decode(std::span(points).subspan(i * genes, genes));
    const HeldInput held(task.body, p);
    const MotionInput<double> input = held.input();
    const MotionInputs row = rows.part(i, 1, dofs);
    for (std::size_t d = 0; d < dofs; ++d) {
      EXPECT_NEAR(static_cast<double>(row.inverse_weights[d]), input.inverse_weights[d],
                  1e-6 * input.inverse_weights[d]);
      EXPECT_NEAR(static_cast<double>(row.later.inverse_weights[d]), input.later.inverse_weights[d],
                  1e-6 * input.later.inverse_weights[d]);
      EXPECT_NEAR(static_cast<double>(row.posture[d]), input.posture[d], 1e-6);
      EXPECT_NEAR(static_cast<double>(row.later.posture[d]), input.later.posture[d], 1e-6);
    }
    EXPECT_NEAR(static_cast<double>(row.later.switch_at[0]), p.later->switch_at, 1e-7);
  }
}

TEST(TwoPhaseSpace, WhatIsFixedHoldsInBothUnlessTheLaterHasItsOwn) {
  const Task task = two_phases({"right_elbow.weight=3", "twist_deg=10", "later.twist_deg=5",
                                "later.right_elbow.weight=7", "left_hip.flexion.weight=2",
                                "squat_deg=40", "later.lean_deg=20", "switch=0.3"});
  const ReachProblem problem = make_problem(task).value();
  const ParameterSpace space(problem, GeneCode::natural, task.fixed, 2);
  for (const char* name : {"right_elbow.flexion", "later.right_elbow.flexion", "twist",
                           "later.twist", "squat", "later.squat", "later.lean", "switch"}) {
    EXPECT_LT(space.find(name), 0) << name;
  }
  EXPECT_GE(space.find("lean"), 0);
  const Parameters p =
      space.decode(std::vector<double>(static_cast<std::size_t>(space.genes()), 0.9));
  const auto elbow = static_cast<std::size_t>(*task.body.find_dof("right_elbow.flexion"));
  const auto hip = static_cast<std::size_t>(*task.body.find_dof("left_hip.flexion"));
  EXPECT_EQ(p.joints[elbow].weight, 3.0);
  EXPECT_EQ(p.later->joints[elbow].weight, 7.0);
  EXPECT_EQ(p.joints[hip].weight, 2.0);
  EXPECT_EQ(p.later->joints[hip].weight, 2.0);
  EXPECT_EQ(p.later->switch_at, 0.3);
  const std::map<std::string, double> degrees_of{
      {"twist", 10.0}, {"later.twist", 5.0}, {"later.squat", 40.0}, {"later.lean", 20.0}};
  const Plan plan = whole_body_plan(task.body);
  for (const auto& [name, degree] : degrees_of) {
    EXPECT_EQ(testing_support::named_value(plan, p, name), radians(degree)) << name;
  }
}

TEST(TwoPhaseSearch, DeliversStoopsAndBentKneesThatReachWithinAllLimits) {
  Task task = two_phases();
  task.duration = 2.0;  // what ankles have the strength for to let a body down into a squat
  const ReachProblem problem = make_problem(task).value();
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  // jolts are the fourth power of a worst moment
  EXPECT_LT(generation.replay_difference, 0.4);
  ASSERT_GE(generation.candidates.size(), 3U);
  double least = 100.0;
  double most = 0.0;
  for (const Candidate& candidate : generation.candidates) {
    EXPECT_TRUE(candidate.parameters.later.has_value());
    EXPECT_LE(candidate.goals[0].error, kReachTolerance);
    EXPECT_TRUE(candidate.measures.over_limit.empty());
    EXPECT_LE(MeasuredMotion(problem, candidate.motion.clip).contact_slide, kReachTolerance);
    const double index = candidate.final_posture.stoop_squat_index.value();
    least = std::fmin(least, index);
    most = std::fmax(most, index);
  }
  EXPECT_LT(least, 0.5 * (kSquatIndex + kStoopIndex) + 5.0);
  EXPECT_GT(most, least + 5.0);
  const Candidate& best = generation.candidates.front();
  EXPECT_EQ(regenerate(task, best.parameters).value().candidates[0].motion.clip.angles,
            best.motion.clip.angles);
}

TEST(TwoPhaseSearch, SquatDialIsTheKneesFlexionAtTheEnd) {
  const Task task = two_phases({"squat_deg=60"});
  const auto knee = static_cast<std::size_t>(*task.body.find_dof("right_knee.flexion"));
  const GenerateResult generation = generate(task).value();
  for (const Candidate& candidate : generation.candidates) {
    EXPECT_NEAR(degrees(candidate.final_posture.knee_flexion - task.body.start()[knee]), 60.0,
                13.0);
  }
}

TEST(TwoPhaseSearch, AnotherSquatInTheLaterPhaseIsKept) {
  Task task = two_phases({"squat_deg=20", "later.squat_deg=90"});
  task.evaluations = 600;
  const GenerateResult generation = generate(task).value();
  for (const Candidate& candidate : generation.candidates) {
    EXPECT_EQ(candidate.parameters.posture.modes[0], radians(20.0));
    EXPECT_EQ(candidate.parameters.later->modes[0], radians(90.0));
  }
}

TEST(TwoPhaseSearch, ByNlpIkReachesTheGoal) {
  Task task = two_phases();
  task.generator = MotionGenerator::nlp_ik;
  task.evaluations = 40;
  const GenerateResult generation = generate(task).value();
  EXPECT_TRUE(generation.meets_goals());
  EXPECT_TRUE(generation.candidates[0].measures.over_limit.empty());
}

TEST(TwoPhaseSearch, OfAnotherPresetOrNumberIsRefused) {
  Task task = two_phases();
  for (const Preset preset : {Preset::paper, Preset::layers}) {
    EXPECT_THAT(message(with_preset(task, preset)), HasSubstr("has one phase; flat knows two"));
  }
  for (const int phases : {0, 3, -1}) {
    task.phases = phases;
    EXPECT_THAT(message(task), HasSubstr("allowed are 1 and 2"));
  }
}

TEST(TwoPhaseSearch, RefusesFixedParametersThatDoNotFit) {
  Task task = two_phases({"later.squat_deg=60"});
  task.fixed->set.pop_back();
  EXPECT_THAT(message(task), HasSubstr("of another body"));
  task = two_phases({"later.squat_deg=60"});
  task.phases = 1;
  EXPECT_THAT(message(task), HasSubstr("a later phase is fixed"));
  task = two_phases({"switch=0.4"});
  task.fixed->set.assign(task.fixed->set.size(), true);
  EXPECT_THAT(message(task), HasSubstr("every parameter is fixed"));
}

TEST(TwoPhaseMotion, EditedParametersAreChecked) {
  const Task task = two_phases();
  Parameters good = uniform_parameters(task.body);
  add_later_phase(good);
  EXPECT_TRUE(regenerate(task, good));
  const auto refused = [&](auto change) {
    Parameters parameters = good;
    change(*parameters.later);
    const Result<GenerateResult> generation = regenerate(task, parameters);
    EXPECT_FALSE(generation);
    return generation ? "" : generation.error().to_string();
  };
  EXPECT_THAT(refused([](LaterPhase& l) { l.switch_at = 0.9; }), HasSubstr("switch"));
  EXPECT_THAT(refused([](LaterPhase& l) { l.switch_at = std::nan(""); }), HasSubstr("switch"));
  EXPECT_THAT(refused([](LaterPhase& l) { l.joints.pop_back(); }),
              HasSubstr("later joint weights"));
  EXPECT_THAT(refused([](LaterPhase& l) { l.joints[0].weight = 0.0; }), HasSubstr("later."));
  EXPECT_THAT(refused([](LaterPhase& l) { l.modes = {0.0}; }), HasSubstr("1 later posture values"));
}

}  // namespace
}  // namespace shigusa
