// SPDX-License-Identifier: MIT
#include "experiments/independent_reach.hpp"

#include <gtest/gtest.h>

#include <shigusa/request.hpp>

#include "experiments/subjects.hpp"
#include "problem/make_problem.hpp"
#include "problem/reachability.hpp"
#include "support/bodies.hpp"
#include "support/reach_bounds.hpp"

namespace shigusa::bench {
namespace {

using namespace testing_support;

constexpr int kStarts = 20;

// (m) remaining distance of closest_reach to a goal, within the limits
double library_distance(const PosedBody& posed, const Vec3d& goal) {
  Task task(posed);
  task.goals = {{"right_hand", goal}};
  return closest_reach(make_problem(task).value()).distance;
}

class IndependentReachOf : public testing::TestWithParam<const char*> {
 protected:
  PosedBody body_ = std::string(GetParam()) == "half" ? half_body() : full_body();
};

TEST_P(IndependentReachOf, AgreesWithClosestReachWhereItIsClear) {
  IndependentReach reach(body_, "right_hand");
  Random places(31);
  Random starts(32);
  int in_reach = 0;
  int out_of_reach = 0;
  for (int k = 0; k < 40; ++k) {
    const Vec3d goal = random_place(places);
    SCOPED_TRACE(k);
    const double distance = library_distance(body_, goal);
    // at the edge of reach both may stop short
    if (distance > kReachTolerance && distance < 0.03) continue;
    const bool reached = distance <= kReachTolerance;
    EXPECT_EQ(reach.posture(goal, kStarts, starts).has_value(), reached) << distance << " m";
    (reached ? in_reach : out_of_reach) += 1;
  }
  EXPECT_GT(in_reach, 8);
  EXPECT_GT(out_of_reach, 8);
}

TEST_P(IndependentReachOf, FindsPosturesThatAPersonCanStandIn) {
  IndependentReach reach(body_, "right_hand");
  Random starts(33);
  const Kinematics<double> stands = placed(body_, body_.home.angles);
  for (const Vec3d& goal : reachable_goals(body_, 10, 34)) {
    const auto angles = reach.posture(goal, kStarts, starts);
    ASSERT_TRUE(angles);
    // linear inequalities hold but for rounding
    EXPECT_LE(excess_of(body_, *angles), 1e-9);
    EXPECT_LE(norm(effector_position(body_, *angles, "right_hand") - goal),
              IndependentReach::kThere);
    const Kinematics<double> now = placed(body_, *angles);
    for (const Foot& foot : body_.body.feet()) {
      for (const Vec3d& corner : foot.outline) {
        // three corners are held; a fourth is off by no more than their sum
        EXPECT_LE(norm(now.point(foot.link, corner) - stands.point(foot.link, corner)),
                  3.0 * IndependentReach::kThere);
      }
    }
  }
}

TEST_P(IndependentReachOf, FindsNothingBeyondTheStretchedBody) {
  IndependentReach reach(body_, "right_hand");
  Random starts(35);
  for (const Vec3d& goal : {Vec3d{0.0, 3.0, 0.0}, Vec3d{-2.5, 1.0, 0.0}, Vec3d{0.0, 1.0, 2.5}}) {
    ASSERT_GT(stretched_distance(body_, goal), 0.0);
    EXPECT_FALSE(reach.posture(goal, kStarts, starts));
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, IndependentReachOf, testing::Values("half", "full"));

TEST(ReachableGoals, AreTheSameForTheSameSeed) {
  const PosedBody posed = full_body();
  const std::vector<Vec3d> goals = reachable_goals(posed, 6, 7);
  const std::vector<Vec3d> again = reachable_goals(posed, 4, 7);
  const std::vector<Vec3d> others = reachable_goals(posed, 4, 8);
  for (std::size_t k = 0; k < again.size(); ++k) {
    EXPECT_EQ(norm(again[k] - goals[k]), 0.0) << "fewer goals are the first of more";
    EXPECT_GT(norm(others[k] - goals[k]), 0.0);
  }
}

}  // namespace
}  // namespace shigusa::bench
