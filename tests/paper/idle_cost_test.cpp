// SPDX-License-Identifier: MIT
#include "paper/idle_cost.hpp"

#include <gtest/gtest.h>

#include <shigusa/request.hpp>

#include "support/layered.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(IdleCost, IsOfAFreeArmThatComesIntoTheBody) {
  const PosedBody posed = human_body();
  const Task task =
      with_preset(Task(posed, {.goals = {{"right_hand", {-0.3, 1.2, 0.4}}}}), Preset::human);
  const LayeredProblem problem = testing_support::make_layered_problem(task);
  const LayeredSetup setup(problem);
  IdleCost<double> idle(setup);
  const std::vector<double> none(posed.body.dofs().size());
  // Of a frame at the start and another one, but for one angle.
  const auto cost_of = [&](const char* freedom, double before, double after) {
    idle.reset();
    for (const double by : {before, after}) {
      std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
      angles[static_cast<std::size_t>(posed.body.find_dof(freedom).value())] += radians(by);
      const Kinematics<double> now = placed(posed, angles);
      idle.add({{angles, none, {}, none, none, 0.02}, now, {}});
    }
    return idle.cost();
  };
  EXPECT_EQ(cost_of("left_shoulder.abduction", 0.0, 30.0), 0.0);
  EXPECT_EQ(cost_of("right_shoulder.abduction", 0.0, -30.0), 0.0);
  EXPECT_GT(cost_of("left_shoulder.abduction", 0.0, -5.0), 0.1);
  EXPECT_LT(cost_of("left_shoulder.abduction", 0.0, -5.0), 0.9);
  EXPECT_EQ(cost_of("left_shoulder.abduction", 0.0, -20.0), kIdleCollisionWeight);
  // without the depth at the start
  EXPECT_EQ(cost_of("left_shoulder.abduction", -20.0, -20.0), 0.0);
  EXPECT_EQ(cost_of("left_shoulder.abduction", -20.0, -5.0), 0.0);
}

}  // namespace
}  // namespace shigusa
