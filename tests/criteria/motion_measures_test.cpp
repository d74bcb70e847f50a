// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/motion_measures.hpp>

#include "support/motions.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(JointLoads, TellTheWorstMomentOfEachJoint) {
  BodyDefinition chain = chain_definition({{Axis::x, 1.0, 1.0}});
  chain.dofs[0].torque_positive = 100.0;
  chain.dofs[0].torque_negative = 50.0;
  const BodyModel body(chain);
  Motion motion = motion_through(body, {{0.0}, {0.0}, {0.0}, {0.0}});
  motion.torques = {20.0, -40.0, 70.0, 0.0};
  const std::vector<JointLoad> loads = joint_loads(body, motion);
  ASSERT_EQ(loads.size(), 1u);
  EXPECT_EQ(loads[0].dof, 0);
  EXPECT_DOUBLE_EQ(loads[0].torque, -40.0);
  EXPECT_DOUBLE_EQ(loads[0].share, 0.8);
  EXPECT_DOUBLE_EQ(loads[0].time, motion.clip.frame_time);
}

}  // namespace
}  // namespace shigusa
