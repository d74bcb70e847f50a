// SPDX-License-Identifier: MIT
#include "rig/twist_bones.hpp"

#include <gmock/gmock.h>

#include "rig/find_humanoid.hpp"
#include "rig/humanoid_names.hpp"
#include "rig/stick_figure.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

std::vector<TwistBone> found(const StickFigure& figure) {
  const Skeleton skeleton = figure.skeleton();
  const std::vector<Transformd> world = figure.world();
  return find_twist_bones(skeleton, world, find_humanoid(skeleton, world).value());
}

TEST(TwistNames, OfAllConventionsAreRead) {
  for (const char* name : {"lowerarm_twist_01_l",
                           "upperarm_twist_02_r",
                           "thigh_twist_01_l",
                           "calf_twist_01_r",
                           "LeftForeArmTwist",
                           "LeftForeArmRoll",
                           "LeafLeftArmRoll1",
                           "CC_Base_L_ForearmTwist01",
                           "CC_Base_R_ThighTwist02",
                           "lForearmTwist",
                           "lShldrTwist",
                           "Bip01 L ForeTwist",
                           "Bip01 LUpArmTwist",
                           "ValveBiped.Bip01_L_Ulna",
                           "左腕捩",
                           "右手捩",
                           "右手捩1",
                           "Twist_ForeArm_L",
                           "forearm_twist.l",
                           "J_Sec_L_ForearmTwist"}) {
    EXPECT_TRUE(is_twist_name(name)) << name;
  }
  for (const char* name : {"LeftForeArm", "foot_roll_ik.L", "MCH-forearm_twist.L", "左ひじ", "",
                           "twist_ctrl_l", "LeftHandIndex1", "rollover"}) {
    EXPECT_FALSE(is_twist_name(name)) << name;
  }
}

TEST(TwistBones, AFigureWithoutAnyHasNone) { EXPECT_TRUE(found(standing_figure()).empty()); }

Vec3d between(StickFigure& figure, std::string_view a, std::string_view b, double share) {
  return figure[a].at + (figure[b].at - figure[a].at) * share;
}

TEST(TwistBones, LeavesAreFoundByNameAndShareByPlace) {
  StickFigure figure = standing_figure();
  const auto add = [&](const char* name, const char* bone, const char* next, double share) {
    figure.add(name, bone, between(figure, bone, next, share) + Vec3d{0, 0, 0.01});
  };
  add("LeftForeArmTwist", "LeftForeArm", "LeftHand", 0.4);
  add("bracelet", "LeftForeArm", "LeftHand", 0.6);
  add("RightUpLegRoll", "RightUpLeg", "RightLeg", 0.25);
  add("twist of the hand", "LeftHand", "LeftForeArm", -0.2);
  const std::vector<TwistBone> twists = found(figure);
  ASSERT_EQ(twists.size(), 2u);
  EXPECT_EQ(twists[0].node, figure.find("LeftForeArmTwist"));
  EXPECT_EQ(twists[0].bone, Bone::left_lower_arm);
  EXPECT_NEAR(twists[0].share, 0.4, 1e-9);
  EXPECT_FALSE(twists[0].chain);
  EXPECT_EQ(twists[1].bone, Bone::right_upper_leg);
  EXPECT_TRUE(untwisted(twists, Bone::left_lower_arm));
  EXPECT_FALSE(untwisted(twists, Bone::right_lower_arm));
  // a leaf leaves the thigh its turn, which the knee needs
  EXPECT_FALSE(untwisted(twists, Bone::right_upper_leg));
}

TEST(TwistBones, ThoseAtTheElbowShareByTheirNumber) {
  StickFigure figure = standing_figure();
  figure.add("LeftForeArmTwist1", "LeftForeArm", figure["LeftForeArm"].at);
  figure.add("LeftForeArmTwist2", "LeftForeArm", figure["LeftForeArm"].at);
  const std::vector<TwistBone> twists = found(figure);
  ASSERT_EQ(twists.size(), 2u);
  EXPECT_NEAR(twists[0].share, 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(twists[1].share, 2.0 / 3.0, 1e-9);
}

TEST(TwistBones, BetweenTwoBonesAnyNameDoesOnTheLineOnly) {
  for (const double off : {0.0, 0.05}) {
    StickFigure figure = standing_figure();
    const Vec3d elbow = figure["LeftForeArm"].at;
    const Vec3d wrist = figure["LeftHand"].at;
    figure = figure.without("LeftForeArm");
    figure.add("LeftForeArm", "LeftArm", elbow);
    figure.add("DEF-2", "LeftForeArm", (elbow + wrist) * 0.5 + Vec3d{0, off, 0});
    figure.add("LeftHand", "DEF-2", wrist);
    const std::vector<TwistBone> twists = found(figure);
    ASSERT_EQ(twists.size(), off == 0.0 ? 1u : 0u);
    if (off != 0.0) continue;
    EXPECT_NEAR(twists[0].share, 0.5, 1e-9);
    EXPECT_TRUE(twists[0].chain);
  }
}

TEST(TwistBones, OnesBesideTheLimbAreItsOwn) {
  StickFigure figure = standing_figure();
  figure.add("LUpArmTwist", "LeftShoulder", between(figure, "LeftArm", "LeftForeArm", 0.3));
  const std::vector<TwistBone> twists = found(figure);
  ASSERT_EQ(twists.size(), 1u);
  EXPECT_EQ(twists[0].bone, Bone::left_upper_arm);
  EXPECT_NEAR(twists[0].share, 0.3, 1e-9);
}

}  // namespace
}  // namespace shigusa
