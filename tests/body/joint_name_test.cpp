// SPDX-License-Identifier: MIT
#include "body/joint_name.hpp"

#include <gtest/gtest.h>

#include <shigusa/human_body.hpp>

namespace shigusa {
namespace {

TEST(JointName, TellsSideJointAndFreedom) {
  const JointPlace hip = parse_joint_name("left_hip.flexion");
  EXPECT_EQ(hip.side, Side::left);
  EXPECT_EQ(hip.joint, "hip");
  EXPECT_EQ(hip.freedom, "flexion");
  const JointPlace chest = parse_joint_name("upper_chest.rotation");
  EXPECT_FALSE(chest.side);
  EXPECT_EQ(chest.joint, "upper_chest");
  EXPECT_EQ(chest.freedom, "rotation");
  EXPECT_EQ(parse_joint_name("right_hand").side, Side::right);
  EXPECT_EQ(parse_joint_name("right_hand").freedom, "");
  EXPECT_EQ(parse_joint_name("").joint, "");
}

TEST(JointName, TellsTheLimb) {
  for (const char* leg : {"left_hip.flexion", "right_foot", "left_toes", "hip.flexion", "legs"}) {
    EXPECT_EQ(parse_joint_name(leg).limb, LimbKind::leg) << leg;
  }
  for (const char* arm : {"left_clavicle.elevation", "right_hand", "left_wrist", "arms"}) {
    EXPECT_EQ(parse_joint_name(arm).limb, LimbKind::arm) << arm;
  }
  for (const char* trunk : {"hips", "spine.flexion", "upper_chest", "head", ""}) {
    EXPECT_EQ(parse_joint_name(trunk).limb, LimbKind::trunk) << trunk;
  }
}

TEST(JointName, OfEachFreedomHasAnImageOnTheOtherSide) {
  const BodyModel body = human_body();
  for (const Dof& dof : body.dofs()) {
    const std::string other = with_other_side(dof.name);
    EXPECT_TRUE(body.find_dof(other)) << other;
    EXPECT_EQ(with_other_side(other), dof.name);
    EXPECT_EQ(without_side(other), without_side(dof.name));
    EXPECT_EQ(other == dof.name, !parse_joint_name(dof.name).side.has_value());
  }
}

// The upper chest's freedoms are its own, and not the chest's of another side.
TEST(JointName, AnUpperChestHasNoSide) {
  EXPECT_EQ(without_side("upper_chest.flexion"), "upper_chest.flexion");
}

}  // namespace
}  // namespace shigusa
