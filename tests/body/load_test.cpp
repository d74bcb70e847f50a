// SPDX-License-Identifier: MIT
#include "body/load.hpp"

#include <gtest/gtest.h>

#include <shigusa/goal.hpp>

#include "dynamics/inverse_dynamics.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// still in a posture
std::vector<double> static_torques(const BodyModel& body, std::span<const double> angles) {
  const Kinematics<double> kinematics = placed(body, angles);
  DynamicsWorkspace<double> work(body);
  const std::vector<double> zero(body.dofs().size());
  std::vector<double> tau(body.dofs().size());
  inverse_dynamics<double>(body, kinematics, {zero, zero}, work, tau);
  return tau;
}

TEST(WithLoad, AddsItsWeightAtTheHand) {
  const PosedBody posed = human_body();
  const int hand = posed.body.find_effector("right_hand").value();
  const BodyModel loaded = with_load(posed, {hand, 10.0});
  EXPECT_NEAR(loaded.mass(), posed.body.mass() + 10.0, 1e-12);
  // the torque of a weight: the hand's Jacobian times it
  const std::vector<double> before = static_torques(posed, posed.home.angles);
  const std::vector<double> after = static_torques(loaded, posed.home.angles);
  const Kinematics<double> kinematics = placed(posed, posed.home.angles);
  const Effector& effector = posed.body.effectors()[static_cast<std::size_t>(hand)];
  const Vec3d at = kinematics.point(effector.link, effector.point);
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    const auto k = static_cast<std::size_t>(d);
    const Vec3d column = cross(kinematics.axis[k], at - kinematics.origin[k]);
    const double expected = posed.body.moves(d, effector.link) ? 10.0 * kGravity * column.y : 0.0;
    EXPECT_NEAR(after[k] - before[k], expected, 1e-9) << posed.body.dof(d).name;
  }
}

TEST(WithLoad, NothingIsNothing) {
  const PosedBody posed = full_body();
  const BodyModel same = with_load(posed, {0, 0.0});
  EXPECT_LT(norm(same.link_mass(8).com - posed.body.link_mass(8).com), 1e-12);
  EXPECT_EQ(same.mass(), posed.body.mass());
}

}  // namespace
}  // namespace shigusa
