// SPDX-License-Identifier: MIT
#include "body/joint_name.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/human.hpp>

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

// Each kind's word is parsed as that kind, on either side or none.
TEST(JointName, EachKindHasItsWord) {
  for (const EnumWord<JointKind>& joint : kEnumWords<JointKind>) {
    for (const EnumWord<FreedomKind>& freedom : kEnumWords<FreedomKind>) {
      for (const std::string side : {"", "left_", "right_"}) {
        const std::string name = side + std::string(joint.word) + "." + std::string(freedom.word);
        EXPECT_TRUE(parse_joint_name(name).is(joint.value, freedom.value)) << name;
      }
    }
  }
  for (const char* other : {"", "tail.wagging", "left_hand_grip", "legs.contraction"}) {
    EXPECT_TRUE(parse_joint_name(other).is(JointKind::other, FreedomKind::other)) << other;
  }
}

// A dof with a common name is found by its kind alone, as by its name.
TEST(JointName, EachFreedomOfAPersonIsFoundByItsPlace) {
  for (const BodyModel& body : {human_body({.heels = true}), full_body(), half_body()}) {
    for (int d = 0; d < body.dof_count(); ++d) {
      const JointPlace& part = body.dof(d).part;
      EXPECT_NE(part.joint_kind, JointKind::other) << body.dof(d).name;
      EXPECT_EQ(body.find_dof(part.joint_kind, part.freedom_kind, part.side), d);
      const std::vector<int> sides = body.dofs_of(part.joint_kind, part.freedom_kind);
      EXPECT_EQ(std::count(sides.begin(), sides.end(), d), 1) << body.dof(d).name;
    }
    for (const Effector& hand : body.effectors()) {
      EXPECT_EQ(body.find_effector(JointKind::hand, *hand.part.side),
                body.find_effector(hand.name));
    }
    EXPECT_FALSE(body.find_dof(JointKind::knee, FreedomKind::flexion));
    EXPECT_FALSE(body.find_dof(JointKind::knee, FreedomKind::rotation, Side::left));
    EXPECT_TRUE(body.dofs_of(JointKind::other, FreedomKind::other).empty());
  }
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

// The upper chest's dofs are its own, not those of the chest.
TEST(JointName, AnUpperChestHasNoSide) {
  EXPECT_EQ(without_side("upper_chest.flexion"), "upper_chest.flexion");
}

}  // namespace
}  // namespace shigusa
