// SPDX-License-Identifier: MIT
#include "criteria/joint_range.hpp"

#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A hinge with the range -0.5 to 1.5 rad: the penalty is full 0.4 rad beyond a limit.
BodyDefinition one_hinge() {
  BodyDefinition body = chain_definition({{}});
  body.dofs[0].lower = -0.5;
  body.dofs[0].upper = 1.5;
  return body;
}

double penalty_at(const PosedBody& body, std::vector<std::vector<double>> frames) {
  return penalty_by<JointRange>(body, motion_through(body, frames));
}

TEST(JointRange, IsZeroUpToTheLimits) {
  const PosedBody body = at_zero(one_hinge());
  EXPECT_EQ(penalty_at(body, {{0.0}, {1.5}, {-0.5}}), 0.0);
}

TEST(JointRange, GrowsInProportionBeyondEitherLimit) {
  const PosedBody body = at_zero(one_hinge());
  EXPECT_NEAR(penalty_at(body, {{0.0}, {1.6}}), 0.25, 1e-15);
  EXPECT_NEAR(penalty_at(body, {{0.0}, {-0.7}}), 0.5, 1e-15);
}

TEST(JointRange, IsFullAtTheMargin) {
  const PosedBody body = at_zero(one_hinge());
  EXPECT_NEAR(penalty_at(body, {{1.9}}), 1.0, 1e-15);
  EXPECT_EQ(penalty_at(body, {{3.0}}), 1.0);
}

TEST(JointRange, CountsTheWorstFrameWhereverItIs) {
  const PosedBody body = at_zero(one_hinge());
  const double alone = penalty_at(body, {{1.7}});
  EXPECT_EQ(penalty_at(body, {{0.0}, {1.7}, {0.0}}), alone);
  EXPECT_EQ(penalty_at(body, {{0.0}, {1.6}, {1.7}}), alone);
}

TEST(JointRange, IsHalfTheWorstJointAndHalfTheMean) {
  BodyDefinition definition = chain_definition({{}, {}, {}, {}});
  for (Dof& dof : definition.dofs) {
    dof.lower = -1.0;
    dof.upper = 1.0;
  }
  // of a range of 2, shares of the margin of 0.4: 0.5, 0.25, 0 and 0
  const double penalty = penalty_at(at_zero(definition), {{1.2, -1.1, 0.0, 0.5}});
  EXPECT_NEAR(penalty, 0.5 * 0.5 + 0.5 * (0.75 / 4), 1e-15);
}

TEST(JointRange, OneJointCountsAsAtMostFull) {
  BodyDefinition definition = chain_definition({{}, {}});
  for (Dof& dof : definition.dofs) dof.upper = 1.0;
  EXPECT_NEAR(penalty_at(at_zero(definition), {{100.0, 0.0}}), 0.75, 1e-15);
}

TEST(JointRange, MarginIsASetting) {
  const PosedBody body = at_zero(one_hinge());
  const Motion motion = motion_through(body, {{1.6}});
  EXPECT_NEAR(penalty_by<JointRange>(body, motion, 0.1), 0.5, 1e-15);
}

TEST(JointRange, BentKneeLetsTheHipFlexFurther) {
  BodyDefinition definition = chain_definition({{}, {}});
  definition.dofs[0].upper = 1.0;
  definition.dofs[1].upper = 2.0;
  definition.couplings = {{.dof = 0, .driver = 1, .gain = 0.5, .driver_full = 0.8}};
  const PosedBody body = at_zero(definition);
  const auto upper = [&](double driver) {
    const std::vector<double> q{0.0, driver};
    return upper_limit(body, 0, q);
  };
  EXPECT_EQ(upper(-0.3), 1.0);
  EXPECT_EQ(upper(0.0), 1.0);
  EXPECT_NEAR(upper(0.4), 1.25, 1e-15);
  EXPECT_EQ(upper(0.8), 1.5);
  EXPECT_EQ(upper(2.0), 1.5);
  EXPECT_GT(penalty_at(body, {{1.2, 0.0}}), 0.0);
  EXPECT_EQ(penalty_at(body, {{1.24, 0.4}}), 0.0);
  EXPECT_GT(penalty_at(body, {{1.26, 0.4}}), 0.0);
}

TEST(JointRange, HumanHipFlexesTo165DegreesOverABentKnee) {
  for (const PosedBody& body : {half_body(), full_body()}) {
    std::vector<double> q(body.body.dofs().size(), 0.0);
    const auto knee = static_cast<std::size_t>(*body.body.find_dof("right_knee.flexion"));
    const int hip = *body.body.find_dof("right_hip.flexion");
    EXPECT_NEAR(degrees(upper_limit(body, hip, q)), 115.0, 1e-12);
    q[knee] = radians(30);
    EXPECT_NEAR(degrees(upper_limit(body, hip, q)), 140.0, 1e-12);
    q[knee] = radians(60);
    EXPECT_NEAR(degrees(upper_limit(body, hip, q)), 165.0, 1e-12);
  }
}

TEST(JointRange, AHumanHipIsWithinItsRangeOverABentKneeOnly) {
  for (const PosedBody& body : {half_body(), full_body()}) {
    for (const char* side : {"right", "left"}) {
      const auto hip = body.body.find_dof(std::string(side) + "_hip.flexion");
      const auto knee = body.body.find_dof(std::string(side) + "_knee.flexion");
      if (!hip) continue;  // of the half body
      std::vector<double> q(body.body.dofs().size(), 0.0);
      q[static_cast<std::size_t>(*hip)] = radians(139);
      // 24° too far, of the 27° that are a fifth of its range
      EXPECT_NEAR(penalty_at(body, {q}), 24.0 / 27.0 * (0.5 + 0.5 / static_cast<double>(q.size())),
                  1e-12);
      q[static_cast<std::size_t>(*knee)] = radians(30);
      EXPECT_EQ(penalty_at(body, {q}), 0.0);
    }
  }
}

TEST(JointRange, NeverFallsAsAJointGoesFurther) {
  const PosedBody body = full_body();
  Random random(51);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> q = random_posture(body, random);
    const auto d = static_cast<std::size_t>(random.below(18));
    q[d] = body.body.dofs()[d].upper;
    double before = penalty_at(body, {q});
    for (int k = 0; k < 20; ++k) {
      // knees only up to where they let the hips go no further
      q[d] += 0.05;
      const double now = penalty_at(body, {q});
      const bool drives_a_limit = body.body.dofs()[d].joint.ends_with("knee");
      if (!drives_a_limit) {
        ASSERT_GE(now, before - 1e-15);
      }
      before = now;
    }
  }
}

// Swing and twist: a shoulder turns outwards by 60° at the side, by 90° when abducted, and inwards
// by 70°.
TEST(JointRange, ALiftedArmTurnsOutFurther) {
  const PosedBody body = human_body();
  for (const std::string side : {"left", "right"}) {
    const int rotation = body.body.find_dof(side + "_shoulder.rotation").value();
    const auto abduction =
        static_cast<std::size_t>(body.body.find_dof(side + "_shoulder.abduction").value());
    std::vector<double> angles(body.body.dofs().size());
    const auto upper = [&](double degrees_aside) {
      angles[abduction] = radians(degrees_aside);
      return degrees(upper_limit(body, rotation, angles));
    };
    EXPECT_NEAR(upper(0.0), 60.0, 1e-9) << side;
    EXPECT_NEAR(upper(-20.0), 60.0, 1e-9) << side;
    EXPECT_NEAR(upper(45.0), 75.0, 1e-9) << side;
    EXPECT_NEAR(upper(90.0), 90.0, 1e-9) << side;
    EXPECT_NEAR(upper(140.0), 90.0, 1e-9) << side;
    EXPECT_NEAR(degrees(body.body.dof(rotation).lower), -70.0, 1e-9) << side;
  }
}

}  // namespace
}  // namespace shigusa
