// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <shigusa/generate.hpp>
#include <shigusa/request.hpp>

#include "problem/make_problem.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Task task_for(const Vec3d& goal) {
  return with_preset(Task(full_body(), {.goals = {{"right_hand", goal}}}), Preset::paper);
}

// The message with which a task is refused, or nothing.
std::string refusal(const Task& task) {
  const Result<ReachProblem> problem = make_problem(task);
  return problem ? "" : problem.error().to_string();
}

TEST(MakeProblem, LeadsTheHandFromWhereItIsToItsGoal) {
  const Task task = task_for({-0.3, 1.0, 0.5});
  const Result<ReachProblem> problem = make_problem(task);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->body, &task.body);
  ASSERT_EQ(problem->goals.size(), 1u);
  EXPECT_EQ(problem->goals[0].effector, task.body.find_effector("right_hand"));
  EXPECT_EQ(problem->goals[0].path.start,
            effector_position(task.body, task.home.angles, "right_hand"));
  EXPECT_EQ(problem->goals[0].path.goal, (Vec3d{-0.3, 1.0, 0.5}));
  EXPECT_EQ(problem->steps, kMotionSteps);
}

TEST(MakeProblem, TakesTheTimeOfTheDistance) {
  const Task task = with_preset(task_for({-0.3, 1.2, 0.4}), Preset::paper);
  const Result<ReachProblem> problem = make_problem(task);
  const EffectorPath& path = problem->goals[0].path;
  // near enough for the arm alone
  EXPECT_EQ(problem->duration, reach_duration(norm(path.goal - path.start), false));
}

TEST(MakeProblem, TakesLongerWhereTheTrunkMustHelp) {
  const Task task = with_preset(task_for({-0.1, 0.2, 0.5}), Preset::paper);
  const Result<ReachProblem> problem = make_problem(task);
  const EffectorPath& path = problem->goals[0].path;
  EXPECT_EQ(problem->duration, reach_duration(norm(path.goal - path.start), true));
}

TEST(MakeProblem, TakesTheLongestTimeOfAllGoals) {
  Task task = task_for({-0.3, 1.2, 0.4});
  task.goals.push_back({"left_hand", {0.1, 0.2, 0.5}});
  const Result<ReachProblem> both = make_problem(task);
  task.goals.erase(task.goals.begin());
  EXPECT_EQ(both->duration, make_problem(task)->duration);
}

TEST(MakeProblem, TakesTheTimeItIsGiven) {
  Task task = task_for({-0.3, 1.0, 0.5});
  for (const double duration : {kTaskDurationMin, 3.0, kTaskDurationMax}) {
    task.duration = duration;
    EXPECT_EQ(make_problem(task)->duration, duration);
  }
}

TEST(MakeProblem, RefusesOtherDurations) {
  Task task = task_for({-0.3, 1.0, 0.5});
  for (const double duration : {0.049, 60.1, 0.0, -1.0, kNaN, kInfinity}) {
    task.duration = duration;
    EXPECT_THAT(refusal(task), HasSubstr("0.05 to 60"));
  }
}

TEST(MakeProblem, RefusesATaskWithoutGoals) {
  Task task = task_for({});
  task.goals.clear();
  EXPECT_THAT(refusal(task), HasSubstr("no goal"));
}

TEST(MakeProblem, NamesTheNearestEffectorOfAMisspeltOne) {
  Task task = task_for({-0.3, 1.0, 0.5});
  task.goals[0].effector = "right_hnad";
  EXPECT_EQ(make_problem(task).error().code, ErrorCode::not_found);
  EXPECT_THAT(refusal(task), HasSubstr("right_hnad"));
  EXPECT_THAT(refusal(task), HasSubstr("'right_hand'"));
}

TEST(MakeProblem, RefusesTwoGoalsForOneEffector) {
  Task task = task_for({-0.3, 1.0, 0.5});
  task.goals.push_back({"right_hand", {0, 1, 0.5}});
  EXPECT_THAT(refusal(task), HasSubstr("two goals for right_hand"));
}

TEST(MakeProblem, RefusesCoordinatesThatAreNoPlace) {
  for (const double bad : {kNaN, kInfinity, -kInfinity, 100.5, -100.5}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d goal{0, 1, 0.5};
      goal[axis] = bad;
      const std::string message = refusal(task_for(goal));
      EXPECT_THAT(message, HasSubstr(std::string(1, "xyz"[axis]) + " coordinate"));
      EXPECT_THAT(message, HasSubstr("right_hand"));
      EXPECT_THAT(message, HasSubstr("-100 to 100"));
    }
  }
}

TEST(MakeProblem, TakesCoordinatesAndLoadsUpToTheirRange) {
  Task task = task_for({100, -100, 100});
  EXPECT_EQ(refusal(task), "");
  task.look_at = Vec3d{-100, 100, -100};
  task.goals[0].load = kLoadMax;
  EXPECT_EQ(refusal(task), "");
  task.goals[0].load = kLoadMax + 0.1;
  EXPECT_THAT(refusal(task), HasSubstr("load"));
  task.look_at = Vec3d{0, 0, 100.5};
  EXPECT_THAT(refusal(task), HasSubstr("look_at"));
}

TEST(PreparedTask, KeepsTheFootThatBears) {
  Task task = task_for({-0.3, 1.0, 0.5});
  const auto refused = [&task](const std::vector<std::string>& contacts) {
    task.contacts = contacts;
    const Result<PreparedTask> made = PreparedTask::of(task);
    return made ? "" : made.error().to_string();
  };
  EXPECT_EQ(refused({"right_foot"}), "");
  EXPECT_EQ(refused({"left_foot", "right_foot"}), "");
  EXPECT_THAT(refused({"left_foot"}), HasSubstr("right_foot"));
  EXPECT_THAT(refused({"right_foot", "tail"}), HasSubstr("'tail'"));
}

// A task whose criteria were changed.
template <class Change>
std::string refusal_of_criteria(Change change) {
  Task task = task_for({-0.3, 1.0, 0.5});
  change(task.criteria);
  return refusal(task);
}

TEST(MakeProblem, RefusesWeightsThatSayNothing) {
  using C = CriteriaSettings;
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::joint_range].weight = -0.1; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::balance].weight = kNaN; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::torque].weight = kInfinity; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::head].weight = -1.0; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c = {{CriterionKind::torque, 0.0}}; }), "");
  EXPECT_EQ(refusal_of_criteria([](C& c) { c = {{CriterionKind::torque, 0.1}}; }), "");
}

TEST(CriteriaContext, HasTheEyesOnTheFirstGoal) {
  Task task = task_for({-0.3, 1.0, 0.5});
  EXPECT_EQ(criteria_context(task).gaze, (Vec3d{-0.3, 1.0, 0.5}));
  task.look_at = Vec3d{0, 1, 2};
  EXPECT_EQ(criteria_context(task).gaze, (Vec3d{0, 1, 2}));
}

TEST(MakeProblem, RefusesScalesThatAreNotAboveZero) {
  using C = CriteriaSettings;
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::joint_range].scale = 0.0; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::balance].scale = kNaN; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::torque].scale = -1.0; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::balance_zone].scale = 0.0; }), "");
  EXPECT_NE(refusal_of_criteria([](C& c) { c[CriterionKind::head].scale = kNaN; }), "");
  const auto with_user = [](double weight, double scale) {
    return refusal_of_criteria([&](C& c) {
      c.user = {{.name = "own",
                 .weight = weight,
                 .scale = scale,
                 .value = [](const BodyModel&, const Motion&) { return 0.5; }}};
    });
  };
  EXPECT_EQ(with_user(0.1, 1.0), "");
  EXPECT_NE(with_user(0.1, 0.0), "");
  EXPECT_NE(with_user(-0.1, 1.0), "");
  EXPECT_NE(with_user(0.1, kNaN), "");
}

TEST(MakeProblem, RefusesToDeliverOrEvaluateNothing) {
  Task task = task_for({-0.3, 1.0, 0.5});
  task.candidates = 0;
  EXPECT_THAT(refusal(task), HasSubstr("candidates is 0"));
  task.candidates = 1;
  task.evaluations = task.genetic.population - 1;
  EXPECT_THAT(refusal(task), HasSubstr("evaluations is 7"));
  task.evaluations = task.genetic.population;
  EXPECT_EQ(refusal(task), "");
}

TEST(Preset, HasItsOwnTraits) {
  for (const auto& [preset, word] : kEnumWords<Preset>) {
    EXPECT_EQ(traits_of(preset).preset, preset) << word;
    EXPECT_EQ(value_of<Preset>(word, "preset"), preset) << word;
  }
}

TEST(Preset, TakesEaseWithoutLayersAndGazeWhereItIsNatural) {
  for (const PresetTraits& preset : kPresets) {
    Task task = with_preset(task_for({-0.3, 1.0, 0.5}), preset.preset);
    EXPECT_EQ(refusal(task), "");
    task.ease = kEaseMax;
    EXPECT_THAT(refusal(task), HasSubstr(preset.layers ? preset.word : ""));
    EXPECT_EQ(refusal(task).empty(), !preset.layers) << preset.word;
    task.ease = 0.0;
    task.gaze_lead = kGazeLeadMost;
    EXPECT_EQ(refusal(task).empty(), preset.natural) << preset.word;
  }
}

TEST(MakeProblem, PathsSwayOutwardsSquareToWayAndBow) {
  Task task = with_preset(Task(full_body()), Preset::flat);
  for (const Vec3d& way : {Vec3d{0, 0, 0.4}, Vec3d{0.1, -0.5, 0.1}, Vec3d{0, 0.9, 0.3}}) {
    for (const double side : {1.0, -1.0}) {
      const char* hand = side > 0.0 ? "left_hand" : "right_hand";
      task.goals = {{hand, {}}};
      const Vec3d from = make_problem(task)->goals[0].path.start;
      task.goals = {{hand, from + Vec3d{side * way.x, way.y, way.z}}};
      const ReachGoal goal = make_problem(task)->goals[0];
      EXPECT_NEAR(norm(goal.sway), norm(way), 1e-12);
      EXPECT_NEAR(dot(goal.sway, goal.bow), 0.0, 1e-12);
      EXPECT_NEAR(dot(goal.sway, goal.path.goal - goal.path.start), 0.0, 1e-12);
      EXPECT_GT(side * goal.sway.x, 0.9 * norm(way));
    }
  }
}

}  // namespace
}  // namespace shigusa
