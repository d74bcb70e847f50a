// SPDX-License-Identifier: MIT
#include "problem/rise.hpp"

#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "generate/attempt.hpp"
#include "plan/assignment.hpp"
#include "problem/problem.hpp"
#include "rollout/reach_problem.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// The posture that a person's best reach for a goal ends in, at rest.
State end_of_reach(const PosedBody& posed, const Vec3d& goal) {
  Task task(posed, {.goals = {{"right_hand", goal}}});
  task.evaluations = 256;
  const Clip clip = generate(task).value().candidates.at(0).motion.clip;
  return {.angles = clip.state(clip.frames - 1).angles};
}

TEST(RiseOf, WhoStandsHasNone) {
  for (const PosedBody& posed : {half_body(), full_body(), human_body()}) {
    EXPECT_TRUE(rise_of(posed, {.start = posed.home}).empty()) << posed.body.name();
  }
  EXPECT_TRUE(rise_of(chain({{}, {}}), {.start = chain({{}, {}}).home}).empty());
}

TEST(RiseOf, LeadsUprightOnTheFeetAsTheyStand) {
  const PosedBody posed = human_body();
  const Vec3d stands = effector_position(posed, posed.home.angles, "hips");
  for (const Vec3d& goal : {Vec3d{-0.2, 0.1, 0.35}, Vec3d{0.1, 0.3, 0.5}, Vec3d{-0.4, 0.4, 0.3}}) {
    const State low = end_of_reach(posed, goal);
    const std::vector<double> rise = rise_of(posed, {.start = low});
    ASSERT_EQ(rise.size(), low.angles.size()) << goal.z;
    ReachProblem problem;
    problem.body = &posed.body;
    problem.context.start = low;
    problem.rise = rise;
    const std::vector<double> upright = problem.standing().angles;
    EXPECT_LT(norm(effector_position(posed, upright, "hips") - stands), 0.03) << goal.z;
    const Foot& left = posed.body.feet()[1];
    EXPECT_LT(norm(placed(posed, upright).point(left.link, left.centre) -
                   placed(posed, low.angles).point(left.link, left.centre)),
              1e-3);
    const Vec3d trunk =
        effector_position(posed, upright, "neck") - effector_position(posed, upright, "hips");
    EXPECT_LT(std::atan2(std::hypot(trunk.x, trunk.z), trunk.y), radians(12.0)) << goal.z;
  }
}

// The end of a second reach from the low posture: mean flexion of the knees (rad), and the trunk's
// lean.
FinalPosture second_end(Task task, const State& low) {
  task.start = low;
  task.evaluations = 864;
  const GenerateResult result = generate(task).value();
  EXPECT_TRUE(result.meets_goals());
  const Candidate& best = result.candidates.at(0);
  EXPECT_EQ(best.goals.size(), task.goals.size());
  EXPECT_EQ(best.motion.effectors.size(), task.goals.size());
  EXPECT_GE(best.motion.clip.frame_time * (best.motion.clip.frames - 1), kRiseTime - 1e-9);
  return best.final_posture;
}

TEST(Rise, WhoBeginsBentStandsUpWhereTheGoalIsMetSo) {
  const PosedBody posed = human_body();
  for (const Vec3d& from : {Vec3d{-0.2, 0.12, 0.3}, Vec3d{-0.05, 0.4, 0.35}}) {
    const State low = end_of_reach(posed, from);
    for (const Vec3d& goal :
         {Vec3d{-0.22, 1.05, 0.38}, Vec3d{-0.22, 1.55, 0.4}, Vec3d{-0.1, 1.85, 0.1}}) {
      const FinalPosture end = second_end(Task(posed, {.goals = {{"right_hand", goal}}}), low);
      EXPECT_LT(end.knee_flexion, radians(20.0)) << from.y << " to " << goal.y;
      EXPECT_LT(std::abs(end.trunk_lean), radians(15.0)) << from.y << " to " << goal.y;
    }
  }
}

TEST(Rise, WhoIsToReachLowAgainStaysLow) {
  const PosedBody posed = human_body();
  const State low = end_of_reach(posed, {-0.2, 0.12, 0.3});
  const FinalPosture end =
      second_end(Task(posed, {.goals = {{"right_hand", {0.1, 0.15, 0.4}}}}), low);
  EXPECT_GT(end.trunk_lean, radians(35.0));
}

// A rise in which the person strains is given more time, as one that is impossible in less.
TEST(Rise, WhoStrainsTakesLonger) {
  const PosedBody posed = human_body();
  Task task(posed, {.goals = {{"right_hand", {-0.22, 1.05, 0.38}}}});
  GenerateResult found;
  found.status = ReachStatus::reached;
  found.candidates.resize(2);
  found.candidates[0].judgement.verdict = Verdict::strains;
  found.candidates[1].judgement.verdict = Verdict::impossible;
  found.candidates[1].judgement.possible_in = 1.5;
  EXPECT_FALSE(slower_rise_attempt(*prepare(task).value(), found));
  task.start = end_of_reach(posed, {-0.2, 0.12, 0.3});
  const auto problem = prepare(task).value();
  EXPECT_EQ(slower_rise_attempt(*problem, found).value().duration, 1.5);
  found.candidates[0].judgement.verdict = Verdict::possible;
  EXPECT_FALSE(slower_rise_attempt(*problem, found));
}

// A squat is fixed at the end of the motion, whatever the knees are at its start.
TEST(Rise, AFixedSquatIsTheKneesAtTheEnd) {
  const PosedBody posed = human_body();
  const State low = end_of_reach(posed, {-0.2, 0.12, 0.3});
  Task task(posed, {.goals = {{"right_hand", {-0.22, 1.0, 0.4}}}});
  const ParameterList list = parameter_list(posed, task.start, task).value();
  for (const double squat : {5.0, 70.0}) {
    task.fixed = no_fixed_parameters(list);
    ASSERT_TRUE(fix_parameter(list, "squat_deg=" + std::to_string(squat), *task.fixed));
    EXPECT_NEAR(degrees(second_end(task, low).knee_flexion), squat, 20.0);
  }
}

}  // namespace
}  // namespace shigusa
