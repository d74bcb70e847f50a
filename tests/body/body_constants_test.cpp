// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A ball joint of three dofs that carries a rod, and a hinge at the rod's end.
BodyDefinition ball_and_hinge() {
  BodyDefinition body = chain_definition({{}, {}, {}, {}});
  for (const std::size_t d : {0UL, 1UL}) {
    body.masses[d] = {};
    body.dofs[d + 1].offset = {};
  }
  body.dofs[1].axis = Axis::y;
  body.dofs[2].axis = Axis::z;
  body.dofs[2].sign = -1.0;
  return body;
}

TEST(BodyConstants, FreedomsAtOneCentreAreOneJoint) {
  const BodyConstants<double> constants(ball_and_hinge());
  ASSERT_EQ(constants.joints.size(), 2U);
  EXPECT_EQ(constants.joints[0].first, 0);
  EXPECT_EQ(constants.joints[0].link, 2);
  EXPECT_EQ(constants.joints[0].parent, -1);
  EXPECT_EQ(constants.joints[1].first, 3);
  EXPECT_EQ(constants.joints[1].link, 3);
  EXPECT_EQ(constants.joints[1].parent, 0);
}

TEST(BodyConstants, AFreedomWhoseLinkHasMassEndsItsJoint) {
  BodyDefinition body = ball_and_hinge();
  body.masses[1].mass = 0.5;
  EXPECT_EQ(BodyConstants<double>(body).joints.size(), 3U);
}

TEST(BodyConstants, AFreedomWhoseLinkHasTwoChildrenEndsItsJoint) {
  BodyDefinition body = ball_and_hinge();
  body.dofs[3].parent = 1;
  const BodyConstants<double> constants(body);
  ASSERT_EQ(constants.joints.size(), 3U);
  EXPECT_EQ(constants.joints[0].link, 1);
  EXPECT_EQ(constants.joints[1].parent, 0);
  EXPECT_EQ(constants.joints[2].parent, 0);
}

TEST(BodyConstants, KeepWhatADofTurnsAbout) {
  const BodyConstants<double> constants(ball_and_hinge());
  EXPECT_EQ(constants.dofs[1].axis, Axis::y);
  EXPECT_FALSE(constants.dofs[1].negative);
  EXPECT_TRUE(constants.dofs[2].negative);
  EXPECT_FALSE(constants.dofs[2].starts_joint);
  EXPECT_TRUE(constants.dofs[3].starts_joint);
  EXPECT_EQ(constants.dofs[3].offset, (Vec3d{0, 1, 0}));
  EXPECT_EQ(constants.dofs[3].parent, 2);
}

TEST(BodyConstants, InertiaIsPrincipalWithoutProductsOfInertia) {
  BodyDefinition body = ball_and_hinge();
  body.masses[2].inertia = {{3, 0, 0}, {0, 4, 0}, {0, 0, 5}};
  body.masses[3].inertia = {{3, 0.1, 0}, {0.1, 4, 0}, {0, 0, 5}};
  const BodyConstants<double> constants(body);
  EXPECT_TRUE(constants.joints[0].principal);
  EXPECT_FALSE(constants.joints[1].principal);
}

TEST(BodyConstants, OfBothBodiesHoldEveryDofAndAllMass) {
  for (const BodyModel& body : {half_body(), full_body()}) {
    const BodyConstants<double>& constants = body.constants<double>();
    ASSERT_EQ(constants.dofs.size(), body.dofs().size());
    double mass = constants.base_mass;
    int next = 0;
    for (const auto& joint : constants.joints) {
      EXPECT_EQ(joint.first, next);
      EXPECT_GE(joint.link, joint.first);
      EXPECT_EQ(joint.massive, joint.mass > 0.0);
      EXPECT_EQ(joint.mass, body.link_mass(joint.link).mass);
      EXPECT_EQ(joint.com, body.link_mass(joint.link).com);
      mass += joint.mass;
      next = joint.link + 1;
    }
    EXPECT_EQ(next, body.dof_count());
    EXPECT_NEAR(mass, body.mass(), 1e-12 * body.mass());
    EXPECT_EQ(constants.total_mass, body.mass());
  }
}

TEST(BodyConstants, InFloatAreThoseInDoubleRounded) {
  for (const BodyModel& body : {half_body(), full_body()}) {
    const BodyConstants<double>& exact = body.constants<double>();
    const BodyConstants<float>& rounded = body.constants<float>();
    ASSERT_EQ(rounded.dofs.size(), exact.dofs.size());
    ASSERT_EQ(rounded.joints.size(), exact.joints.size());
    EXPECT_EQ(rounded.base_origin, to_scalar<float>(exact.base_origin));
    EXPECT_EQ(rounded.base_rotation, to_scalar<float>(exact.base_rotation));
    for (std::size_t d = 0; d < exact.dofs.size(); ++d) {
      EXPECT_EQ(rounded.dofs[d].offset, to_scalar<float>(exact.dofs[d].offset));
      EXPECT_EQ(rounded.dofs[d].parent, exact.dofs[d].parent);
      EXPECT_EQ(rounded.dofs[d].negative, exact.dofs[d].negative);
      EXPECT_EQ(rounded.dofs[d].starts_joint, exact.dofs[d].starts_joint);
    }
    for (std::size_t j = 0; j < exact.joints.size(); ++j) {
      EXPECT_EQ(rounded.joints[j].com, to_scalar<float>(exact.joints[j].com));
      EXPECT_EQ(rounded.joints[j].inertia, to_scalar<float>(exact.joints[j].inertia));
      EXPECT_EQ(rounded.joints[j].link, exact.joints[j].link);
    }
  }
}

}  // namespace
}  // namespace shigusa
