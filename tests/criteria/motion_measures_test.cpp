// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/criteria.hpp>

#include "support/motions.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

PosedBody strong_hinges(std::size_t count) {
  BodyDefinition chain = chain_definition(std::vector<Pendulum>(count));
  for (Dof& dof : chain.dofs) {
    dof.torque_positive = 100.0;
    dof.torque_negative = 50.0;
  }
  return at_zero(chain);
}

TEST(JointLoads, TellTheWorstMomentOfEachJoint) {
  const PosedBody posed = strong_hinges(2);
  Motion motion = motion_through(posed, {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}});
  motion.torques = {20.0, -10.0, -40.0, 5.0, 70.0, 5.0, 0.0, 0.0, 1e9, 1e9};
  motion.torques.resize(8);  // behind the last frame nothing counts
  MotionMeasures measures;
  EXPECT_EQ(most_loaded(measures), nullptr);
  measures.loads = joint_loads(posed, motion);
  const std::vector<JointLoad>& loads = measures.loads;
  ASSERT_EQ(loads.size(), 2u);
  EXPECT_EQ(loads[0].dof, 0);
  EXPECT_DOUBLE_EQ(loads[0].torque, -40.0);
  EXPECT_DOUBLE_EQ(loads[0].share, 0.8);
  EXPECT_DOUBLE_EQ(loads[0].time, motion.clip.frame_time);
  EXPECT_EQ(loads[1].dof, 1);
  EXPECT_DOUBLE_EQ(loads[1].torque, -10.0);
  EXPECT_EQ(loads[1].time, 0.0);
  EXPECT_EQ(most_loaded(measures), &loads[0]);
}

TEST(LimitExcess, TellsTheMostOfEachJointTheWorstFirst) {
  const PosedBody posed = strong_hinges(3);  // to 2 rad both ways
  const Clip clip = motion_through(posed, {{2.002, 0.0, 2.0017}, {2.001, -2.3, 0.0}}).clip;
  const std::vector<LimitExcess> over = limit_excess(posed, clip);
  ASSERT_EQ(over.size(), 2u);
  EXPECT_EQ(over[0].dof, "hinge_1.flexion");
  EXPECT_NEAR(over[0].excess, 0.3, 1e-12);
  EXPECT_EQ(over[1].dof, "hinge_0.flexion");
  EXPECT_NEAR(over[1].excess, 0.002, 1e-12);
}

TEST(Suddenness, OfTorquesIsTheirGreatestChangeAsIfInSixtySteps) {
  const PosedBody posed = strong_hinges(2);
  std::vector<std::vector<double>> postures(31, {0.0, 0.0});
  postures[20] = {0.1, 0.1};  // where the floor presses is nothing to a body without feet
  Motion motion = motion_through(posed, postures);
  for (std::size_t k = 0; k < motion.torques.size(); k += 2)
    motion.torques[k] = 90.0;  // throughout
  motion.torques[7] = 30.0;    // of 150 both ways
  EXPECT_DOUBLE_EQ(suddenness(posed, motion).torque, 0.2 * 30 / 60);
  EXPECT_EQ(suddenness(posed, motion).pressure, 0.0);
}

TEST(Suddenness, OfASlowMotionsPressureIsTheWayOfItsCentreOfMass) {
  const PosedBody posed = full_body();
  const std::vector<double> start(posed.home.angles.begin(), posed.home.angles.end());
  std::vector<double> leans = start;
  leans[static_cast<std::size_t>(posed.body.find_dof("right_ankle.flexion").value())] += 0.01;
  Motion motion = motion_through(posed, {start, leans});
  motion.clip.frame_time = 1e4;  // s, too long for any inertia
  Vec3d way = motion.centre_of_mass[1] - motion.centre_of_mass[0];
  way.y = 0.0;
  EXPECT_GT(norm(way), 0.005);
  EXPECT_NEAR(suddenness(posed, motion).pressure, norm(way) / 60, 1e-6);
}

TEST(Suddenness, JoltsWhereEitherIsSeen) {
  EXPECT_FALSE((Suddenness{.pressure = 0.03, .torque = 0.3}.jolts()));
  EXPECT_TRUE((Suddenness{.pressure = 0.031, .torque = 0.0}.jolts()));
  EXPECT_TRUE((Suddenness{.pressure = 0.0, .torque = 0.31}.jolts()));
}

}  // namespace
}  // namespace shigusa
