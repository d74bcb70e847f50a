// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <shigusa/formats.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>

#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "rig/humanoid_names.hpp"
#include "rig/stick_figure.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;
using Bone = HumanoidBone;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Names of the mapped nodes in the order of HumanoidBone; "-" where there is none.
// The bones that every body has, by the names of their nodes: up to the hands.
constexpr int kLimbBones = static_cast<int>(HumanoidBone::spine);

std::string node_name(const Skeleton& skeleton, int node) {
  return node < 0 ? "-" : skeleton.nodes[static_cast<std::size_t>(node)].name;
}

std::vector<std::string> mapped(const Skeleton& skeleton, const HumanoidMap& map) {
  std::vector<std::string> names;
  for (int b = 0; b < kLimbBones; ++b) {
    names.push_back(node_name(skeleton, map[static_cast<HumanoidBone>(b)]));
  }
  return names;
}

Result<HumanoidMap> find(const StickFigure& figure) {
  return find_humanoid(figure.skeleton(), figure.world());
}

std::vector<std::string> names_found(const StickFigure& figure) {
  const auto map = find(figure);
  EXPECT_TRUE(map) << map.error().to_string();
  return map ? mapped(figure.skeleton(), *map) : std::vector<std::string>();
}

std::string error_of(const StickFigure& figure) {
  const auto map = find(figure);
  EXPECT_FALSE(map);
  return map ? "" : map.error().to_string();
}

const std::vector<std::string> kCaptureNames{
    "Hips",        "Neck",       "Head",     "LeftUpLeg",    "LeftLeg",      "LeftFoot",
    "LeftToeBase", "RightUpLeg", "RightLeg", "RightFoot",    "RightToeBase", "LeftArm",
    "LeftForeArm", "LeftHand",   "RightArm", "RightForeArm", "RightHand"};

// The standing figure under the names of a convention: one for each node of kCaptureNames, then
// those of the clavicles.
StickFigure called(const std::vector<std::string>& names) {
  StickFigure figure = standing_figure();
  for (std::size_t i = 0; i < kCaptureNames.size(); ++i) figure[kCaptureNames[i]].name = names[i];
  figure["LeftShoulder"].name = names[17];
  figure["RightShoulder"].name = names[18];
  return figure;
}

struct Convention {
  const char* what;
  std::vector<std::string> names;
};

class BoneNames : public ::testing::TestWithParam<Convention> {};

TEST_P(BoneNames, OfAConventionAreUnderstood) {
  const StickFigure figure = called(GetParam().names);
  const auto map = find(figure);
  ASSERT_TRUE(map) << map.error().to_string();
  const std::vector<std::string> expected(GetParam().names.begin(), GetParam().names.begin() + 17);
  EXPECT_EQ(mapped(figure.skeleton(), *map), expected);
  EXPECT_THAT(map->doubts, IsEmpty());
}

// The names of one convention from patterns in which @ is the side.
std::vector<std::string> sided(const std::string& left, const std::string& right,
                               const std::array<std::string, 3>& middle,
                               const std::array<std::string, 8>& patterns) {
  const auto name = [&](std::size_t i, bool is_left) {
    std::string text = patterns[i];
    return text.replace(text.find('@'), 1, is_left ? left : right);
  };
  std::vector<std::string> names(middle.begin(), middle.end());
  for (const auto& [from, to] : {std::pair(0, 4), std::pair(4, 7)}) {
    for (const bool is_left : {true, false}) {
      for (int i = from; i < to; ++i) names.push_back(name(static_cast<std::size_t>(i), is_left));
    }
  }
  names.push_back(name(7, true));
  names.push_back(name(7, false));
  return names;
}

INSTANTIATE_TEST_SUITE_P(
    Conventions, BoneNames,
    ::testing::Values(
        Convention{"Capture", sided("Left", "Right", {"Hips", "Neck", "Head"},
                                    {"@UpLeg", "@Leg", "@Foot", "@ToeBase", "@Arm", "@ForeArm",
                                     "@Hand", "@Shoulder"})},
        Convention{"ClassicBvh", sided("Left", "Right", {"Hips", "Neck", "Head"},
                                       {"@Hip", "@Knee", "@Ankle", "@Toe", "@Shoulder", "@Elbow",
                                        "@Wrist", "@Collar"})},
        Convention{"Cmu", sided("l", "r", {"root", "lowerneck", "head"},
                                {"@femur", "@tibia", "@foot", "@toes", "@humerus", "@radius",
                                 "@wrist", "@clavicle"})},
        Convention{"Mixamo", sided("mixamorig:Left", "mixamorig:Right",
                                   {"mixamorig:Hips", "mixamorig:Neck", "mixamorig:Head"},
                                   {"@UpLeg", "@Leg", "@Foot", "@ToeBase", "@Arm", "@ForeArm",
                                    "@Hand", "@Shoulder"})},
        Convention{"Rigify", sided("L", "R", {"spine", "neck", "head"},
                                   {"thigh.@", "shin.@", "foot.@", "toe.@", "upper_arm.@",
                                    "forearm.@", "hand.@", "shoulder.@"})},
        Convention{"RigifyDeform",
                   sided("L", "R", {"DEF-spine", "DEF-neck", "DEF-head"},
                         {"DEF-thigh.@", "DEF-shin.@", "DEF-foot.@", "DEF-toe.@", "DEF-upper_arm.@",
                          "DEF-forearm.@", "DEF-hand.@", "DEF-shoulder.@"})},
        Convention{"Unreal", sided("l", "r", {"pelvis", "neck_01", "head"},
                                   {"thigh_@", "calf_@", "foot_@", "ball_@", "upperarm_@",
                                    "lowerarm_@", "hand_@", "clavicle_@"})},
        Convention{"Xsens", sided("Left", "Right", {"Pelvis", "Neck", "Head"},
                                  {"@UpperLeg", "@LowerLeg", "@Foot", "@Toe", "@UpperArm",
                                   "@ForeArm", "@Hand", "@Shoulder"})},
        Convention{"VrmCamel", sided("left", "right", {"hips", "neck", "head"},
                                     {"@UpperLeg", "@LowerLeg", "@Foot", "@Toes", "@UpperArm",
                                      "@LowerArm", "@Hand", "@Shoulder"})},
        Convention{"VrmSnake", sided("left", "right", {"hips", "neck", "head"},
                                     {"@_upper_leg", "@_lower_leg", "@_foot", "@_toes",
                                      "@_upper_arm", "@_lower_arm", "@_hand", "@_shoulder"})},
        Convention{"VRoid", sided("L", "R", {"J_Bip_C_Hips", "J_Bip_C_Neck", "J_Bip_C_Head"},
                                  {"J_Bip_@_UpperLeg", "J_Bip_@_LowerLeg", "J_Bip_@_Foot",
                                   "J_Bip_@_ToeBase", "J_Bip_@_UpperArm", "J_Bip_@_LowerArm",
                                   "J_Bip_@_Hand", "J_Bip_@_Shoulder"})},
        Convention{"Biped", sided("L", "R", {"Bip01 Pelvis", "Bip01 Neck", "Bip01 Head"},
                                  {"Bip01 @ Thigh", "Bip01 @ Calf", "Bip01 @ Foot", "Bip01 @ Toe0",
                                   "Bip01 @ UpperArm", "Bip01 @ Forearm", "Bip01 @ Hand",
                                   "Bip01 @ Clavicle"})},
        Convention{"Poser", sided("l", "r", {"hip", "neck", "head"},
                                  {"@Thigh", "@Shin", "@Foot", "@Toe", "@Shldr", "@ForeArm",
                                   "@Hand", "@Collar"})},
        Convention{"Motive", sided("L", "R", {"Hip", "Neck", "Head"},
                                   {"@Thigh", "@Shin", "@Foot", "@Toe", "@UArm", "@FArm", "@Hand",
                                    "@Shoulder"})},
        Convention{"Smpl", sided("L", "R", {"Pelvis", "Neck", "Head"},
                                 {"@_Hip", "@_Knee", "@_Ankle", "@_Foot", "@_Shoulder", "@_Elbow",
                                  "@_Wrist", "@_Collar"})},
        Convention{"Kinect", sided("Left", "Right", {"SpineBase", "Neck", "Head"},
                                   {"Hip@", "Knee@", "Ankle@", "Foot@", "Shoulder@", "Elbow@",
                                    "Wrist@", "Collar@"})},
        Convention{"MixamoNumbered",
                   sided("mixamorig9:Left", "mixamorig9:Right",
                         {"mixamorig9:Hips", "mixamorig9:Neck", "mixamorig9:Head"},
                         {"@UpLeg", "@Leg", "@Foot", "@ToeBase", "@Arm", "@ForeArm", "@Hand",
                          "@Shoulder"})},
        Convention{"MixamoWithoutColon",  // as three.js and some converters leave it
                   sided("mixamorigLeft", "mixamorigRight",
                         {"mixamorigHips", "mixamorigNeck", "mixamorigHead"},
                         {"@UpLeg", "@Leg", "@Foot", "@ToeBase", "@Arm", "@ForeArm", "@Hand",
                          "@Shoulder"})},
        Convention{"MayaEscaped",
                   sided("L", "R", {"hipsFBXASC046", "neckFBXASC046", "headFBXASC046"},
                         {"thighFBXASC046@", "shinFBXASC046@", "footFBXASC046@", "toeFBXASC046@",
                          "upper_armFBXASC046@", "forearmFBXASC046@", "handFBXASC046@",
                          "shoulderFBXASC046@"})},
        Convention{
            "MayaNamespace",
            sided("Left", "Right",
                  {"char:rigFBXASC058Hips", "char:rigFBXASC058Neck", "char:rigFBXASC058Head"},
                  {"char:rigFBXASC058@UpLeg", "char:rigFBXASC058@Leg", "char:rigFBXASC058@Foot",
                   "char:rigFBXASC058@ToeBase", "char:rigFBXASC058@Arm",
                   "char:rigFBXASC058@ForeArm", "char:rigFBXASC058@Hand",
                   "char:rigFBXASC058@Shoulder"})},
        Convention{"AdvancedSkeleton", sided("L", "R", {"Root_M", "Neck_M", "Head_M"},
                                             {"Hip_@", "Knee_@", "Ankle_@", "Toes_@", "Shoulder_@",
                                              "Elbow_@", "Wrist_@", "Scapula_@"})},
        Convention{"CharacterCreator",
                   sided("L", "R", {"CC_Base_Hip", "CC_Base_Neck", "CC_Base_Head"},
                         {"CC_Base_@_Thigh", "CC_Base_@_Calf", "CC_Base_@_Foot",
                          "CC_Base_@_ToeBase", "CC_Base_@_Upperarm", "CC_Base_@_Forearm",
                          "CC_Base_@_Hand", "CC_Base_@_Clavicle"})},
        Convention{"Source", sided("L", "R",
                                   {"ValveBiped.Bip01_Pelvis", "ValveBiped.Bip01_Neck1",
                                    "ValveBiped.Bip01_Head1"},
                                   {"ValveBiped.Bip01_@_Thigh", "ValveBiped.Bip01_@_Calf",
                                    "ValveBiped.Bip01_@_Foot", "ValveBiped.Bip01_@_Toe0",
                                    "ValveBiped.Bip01_@_UpperArm", "ValveBiped.Bip01_@_Forearm",
                                    "ValveBiped.Bip01_@_Hand", "ValveBiped.Bip01_@_Clavicle"})},
        Convention{"Genesis8", sided("l", "r", {"hip", "neckLower", "head"},
                                     {"@ThighBend", "@Shin", "@Foot", "@Toe", "@ShldrBend",
                                      "@ForearmBend", "@Hand", "@Collar"})},
        Convention{"Genesis9", sided("l", "r", {"hip", "neck1", "head"},
                                     {"@_thigh", "@_shin", "@_foot", "@_toes", "@_upperarm",
                                      "@_forearm", "@_hand", "@_shoulder"})},
        Convention{"MakeHuman", sided("L", "R", {"root", "neck01", "head"},
                                      {"upperleg01.@", "lowerleg01.@", "foot.@", "toe1-1.@",
                                       "upperarm01.@", "lowerarm01.@", "wrist.@", "clavicle.@"})},
        Convention{"SmplFbx",
                   sided("L", "R", {"m_avg_Pelvis", "m_avg_Neck", "m_avg_Head"},
                         {"m_avg_@_Hip", "m_avg_@_Knee", "m_avg_@_Ankle", "m_avg_@_Foot",
                          "m_avg_@_Shoulder", "m_avg_@_Elbow", "m_avg_@_Wrist", "m_avg_@_Collar"})},
        Convention{"SmplX", sided("left", "right", {"pelvis", "neck", "head"},
                                  {"@_hip", "@_knee", "@_ankle", "@_foot", "@_shoulder", "@_elbow",
                                   "@_wrist", "@_collar"})},
        Convention{"PerceptionNeuron",
                   sided("Robot_Left", "Robot_Right", {"Robot_Hips", "Robot_Neck", "Robot_Head"},
                         {"@UpLeg", "@Leg", "@Foot", "@ToeBase", "@Arm", "@ForeArm", "@Hand",
                          "@Shoulder"})},
        Convention{"Rokoko", sided("Left", "Right", {"Hips", "Neck", "Head"},
                                   {"@Thigh", "@Shin", "@Foot", "@Toe", "@Arm", "@ForeArm", "@Hand",
                                    "@Shoulder"})},
        Convention{"Cascadeur", sided("l", "r", {"pelvis", "neck", "head"},
                                      {"thigh_@", "calf_@", "foot_@", "toe_@", "arm_@", "forearm_@",
                                       "hand_@", "clavicle_@"})},
        Convention{"KayKit", sided("l", "r", {"hips", "neck", "head"},
                                   {"upperleg.@", "lowerleg.@", "foot.@", "toes.@", "upperarm.@",
                                    "lowerarm.@", "wrist.@", "shoulder.@"})},
        Convention{"Quaternius", sided("L", "R", {"Hips", "Neck", "Head"},
                                       {"UpperLeg.@", "LowerLeg.@", "Foot.@", "Toes.@",
                                        "UpperArm.@", "LowerArm.@", "Hand.@", "Shoulder.@"})},
        Convention{"Synty", sided("L", "R", {"Hips", "Neck", "Head"},
                                  {"UpperLeg_@", "LowerLeg_@", "Ankle_@", "Ball_@", "Shoulder_@",
                                   "Elbow_@", "Hand_@", "Clavicle_@"})},
        Convention{"AutoRigPro",
                   sided("l", "r", {"root.x", "neck.x", "head.x"},
                         {"thigh_stretch.@", "leg_stretch.@", "foot.@", "toes_01.@",
                          "arm_stretch.@", "forearm_stretch.@", "hand.@", "shoulder.@"})},
        Convention{"PartBeforeWhich",
                   sided("L", "R", {"Hips", "Neck", "Head"},
                         {"Leg_Upper_@", "Leg_Lower_@", "Foot_@", "Toe_@", "Arm_Upper_@",
                          "Arm_Lower_@", "Hand_@", "Clavicle_@"})},
        Convention{"Sketchfab",
                   sided("L", "R", {"Bip001 Pelvis_03", "Bip001 Neck_016", "Bip001 Head_017"},
                         {"Bip001 @ Thigh_033_58", "Bip001 @ Calf_034", "Bip001 @ Foot_035",
                          "Bip001 @ Toe0_036", "Bip001 @ UpperArm_018", "Bip001 @ Forearm_019",
                          "Bip001 @ Hand_020", "Bip001 @ Clavicle_021"})},
        Convention{"Roblox", sided("Left", "Right", {"LowerTorso", "Neck", "Head"},
                                   {"@UpperLeg", "@LowerLeg", "@Foot", "@Toes", "@UpperArm",
                                    "@LowerArm", "@Hand", "@Shoulder"})},
        Convention{"SecondLife", sided("Left", "Right", {"mPelvis", "mNeck", "mHead"},
                                       {"mHip@", "mKnee@", "mAnkle@", "mFoot@", "mShoulder@",
                                        "mElbow@", "mWrist@", "mCollar@"})},
        Convention{"DeepMotion",
                   sided("l", "r", {"hips_JNT", "neck_JNT", "head_JNT"},
                         {"@_upleg_JNT", "@_leg_JNT", "@_foot_JNT", "@_toebase_JNT", "@_arm_JNT",
                          "@_forearm_JNT", "@_hand_JNT", "@_shoulder_JNT"})},
        Convention{"SourceBip",
                   sided("L", "R", {"bip_pelvis", "bip_neck", "bip_head"},
                         {"bip_hip_@", "bip_knee_@", "bip_foot_@", "bip_toe_@", "bip_upperArm_@",
                          "bip_lowerArm_@", "bip_hand_@", "bip_collar_@"})},
        Convention{"UnityChan", sided("Character1_Left", "Character1_Right",
                                      {"Character1_Hips", "Character1_Neck", "Character1_Head"},
                                      {"@UpLeg", "@Leg", "@Foot", "@ToeBase", "@Arm", "@ForeArm",
                                       "@Hand", "@Shoulder"})},
        Convention{"MmdInBlender", sided("L", "R", {"センター", "首", "頭"},
                                         {"足.@", "ひざ.@", "足首.@", "つま先.@", "腕.@", "ひじ.@",
                                          "手首.@", "肩.@"})},
        Convention{"MmdInEnglish", sided("L", "R", {"center", "neck", "head"},
                                         {"leg_@", "knee_@", "ankle_@", "toe_@", "arm_@", "elbow_@",
                                          "wrist_@", "shoulder_@"})},
        Convention{"Mmd",
                   sided("左", "右", {"センター", "首", "頭"},
                         {"@足", "@ひざ", "@足首", "@つま先", "@腕", "@ひじ", "@手首", "@肩"})}),
    [](const auto& test) { return std::string(test.param.what); });

TEST(BoneName, FingersTwistsAndControlsAreNoBones) {
  for (const char* name :
       {"LeftHandIndex1", "LeftForeArmTwist", "upperarm_twist_01_l", "kneeIK.l", "MCH-foot_ik.L",
        "hand_ctrl_r", "LeftFingerBase", "Armature", "L5", "handslot.l", "foot_roll.L", ""}) {
    EXPECT_EQ(read_bone_name(name).part, BonePart::none) << name;
  }
}

TEST(BoneName, ThumbsAndTipsAreTold) {
  EXPECT_EQ(read_bone_name("lthumb").part, BonePart::thumb);
  EXPECT_EQ(read_bone_name("mixamorig:LeftHandThumb2").part, BonePart::thumb);
  EXPECT_EQ(read_bone_name("HeadTop_End").part, BonePart::tip);
}

TEST(HumanoidMap, HelpersWithABonesNameAreNotTheBone) {
  const std::vector<std::string> names =
      sided("l", "r", {"pelvis", "neck_01", "head"},
            {"thigh_@", "calf_@", "foot_@", "ball_@", "upperarm_@", "lowerarm_@", "hand_@",
             "clavicle_@"});
  StickFigure figure = called(names);
  const Vec3d wrist = figure["hand_l"].at;
  const Vec3d finger = wrist + Vec3d{0.1, 0, 0};
  figure = figure.without("hand_l");
  // before the hand in the file's order, and no bone that goes on
  figure.add("wrist_in_l", "lowerarm_l", wrist + Vec3d{0, 0.02, 0});
  figure.add("hand_l", "lowerarm_l", wrist);
  figure.add("index_01_l", "hand_l", finger);
  figure.add("ankle_back_l", "foot_l", figure["foot_l"].at - Vec3d{0, 0, 0.04});
  figure.add("calf_correctiveRoot_l", "thigh_l", figure["calf_l"].at);
  EXPECT_EQ(names_found(figure), std::vector<std::string>(names.begin(), names.begin() + 17));
}

TEST(HumanoidMap, OfAWholeRigifyRigTheDeformingBonesAreTaken) {
  const auto rig = [](const std::string& prefix) {
    return sided(
        "L", "R", {prefix + "spine", prefix + "neck", prefix + "head"},
        {prefix + "thigh.@", prefix + "shin.@", prefix + "foot.@", prefix + "toe.@",
         prefix + "upper_arm.@", prefix + "forearm.@", prefix + "hand.@", prefix + "shoulder.@"});
  };
  StickFigure figure = called(rig("ORG-"));
  for (const std::string side : {"L", "R"}) {
    const auto chain = [&](const std::string& from, const std::vector<std::string>& bones) {
      std::string parent = from;
      for (const std::string& bone : bones) {
        figure.add("DEF-" + bone + "." + side, parent, figure["ORG-" + bone + "." + side].at);
        parent = "DEF-" + bone + "." + side;
      }
    };
    chain("ORG-spine", {"thigh", "shin", "foot", "toe"});
    chain("ORG-shoulder." + side, {"upper_arm", "forearm", "hand"});
  }
  const std::vector<std::string> found = names_found(figure);
  const std::vector<std::string> expected = rig("DEF-");
  for (std::size_t b = 3; b < found.size(); ++b) EXPECT_EQ(found[b], expected[b]);
}

TEST(HumanoidMap, BonesHaveTheirVrmNames) {
  EXPECT_EQ(humanoid_bone_name(Bone::hips), "hips");
  EXPECT_EQ(humanoid_bone_name(Bone::right_upper_leg), "right_upper_leg");
  EXPECT_EQ(humanoid_bone_name(Bone::right_hand), "right_hand");
}

TEST(HumanoidMap, ShapeAloneTellsAllBones) {
  const StickFigure figure = standing_figure();
  const auto map = find(figure.nameless());
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ(mapped(figure.skeleton(), *map), kCaptureNames);
  EXPECT_THAT(map->doubts, Contains(HasSubstr("found by the skeleton's shape")));
}

TEST(HumanoidMap, ShapeTellsLeftByTheFeetInAnyAxes) {
  // z up, facing -y: the left is then +x … and after a half turn about z it is -x
  for (const double turn : {0.0, kPi}) {
    const Mat3d axes = rotation(Axis::z, turn) * rotation(Axis::x, kPi / 2);
    const StickFigure figure = standing_figure();
    const auto map = find(figure.transformed(axes).nameless());
    ASSERT_TRUE(map) << map.error().to_string();
    EXPECT_EQ(mapped(figure.skeleton(), *map), kCaptureNames);
  }
}

TEST(HumanoidMap, ShapePassesTwistJoints) {
  StickFigure figure = standing_figure();
  for (const char* side : {"Left", "Right"}) {
    for (const auto& [upper, lower] :
         {std::pair("UpLeg", "Leg"), std::pair("Leg", "Foot"), std::pair("Arm", "ForeArm")}) {
      const std::string above = std::string(side) + upper;
      const std::string below = std::string(side) + lower;
      // between two joints, as a new parent of the lower one
      const int parent = figure.find(above);
      const Vec3d middle = (figure[above].at + figure[below].at) * 0.5;
      const int place = figure.find(below);
      figure.points.insert(figure.points.begin() + place, {above + "Half", parent, middle});
      for (auto& point : figure.points) {
        if (point.parent >= place) ++point.parent;
      }
      figure.points[static_cast<std::size_t>(place) + 1].parent = place;
    }
  }
  const auto map = find(figure.nameless());
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ(mapped(figure.skeleton(), *map), kCaptureNames);
}

TEST(HumanoidMap, ShapeWithoutFeetNeedsAGuessOfLeft) {
  StickFigure figure = standing_figure();
  figure = figure.without("LeftToeBase").without("RightToeBase");
  const auto map = find(figure.nameless());
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_THAT(map->doubts, Contains(HasSubstr("left and right are a guess")));
}

TEST(HumanoidMap, SidesInNamesHelpTheShape) {
  StickFigure figure = standing_figure().nameless();
  figure.points[5].name = "Bone.R";
  figure.points[10].name = "Bone.L";
  const auto map = find(figure);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ((*map)[Bone::right_upper_leg], 5);
  EXPECT_THAT(map->doubts, Contains(HasSubstr("feet point backwards")));
}

// A file's own map of its bones, to the capture names' nodes.
HumanoidMap given_map(const StickFigure& figure) {
  HumanoidMap map;
  for (std::size_t b = 0; b < kCaptureNames.size(); ++b)
    map.node[b] = figure.find(kCaptureNames[b]);
  return map;
}

TEST(HumanoidMap, GivenBonesGoBeforeNames) {
  // the names of the arms are exchanged, and those of the legs are meaningless
  StickFigure figure = standing_figure();
  const HumanoidMap given = given_map(figure);
  std::swap(figure["LeftArm"].name, figure["RightArm"].name);
  figure["LeftUpLeg"].name = "a";
  const auto map = find_humanoid(figure.skeleton(), figure.world(), given);
  ASSERT_TRUE(map);
  EXPECT_EQ(mapped(figure.skeleton(), *map), mapped(figure.skeleton(), given));
  EXPECT_THAT(map->doubts, IsEmpty());
}

TEST(HumanoidMap, GivenBonesThatAreNoLimbAreLookedForByNames) {
  const StickFigure figure = standing_figure();
  HumanoidMap given = given_map(figure);
  std::swap(given[Bone::left_lower_leg], given[Bone::right_lower_leg]);
  given[Bone::left_hand] = -1;
  given[Bone::right_hand] = given[Bone::right_lower_arm];
  given[Bone::hips] = given[Bone::head];
  given[Bone::head] = given[Bone::right_hand];
  given[Bone::left_toes] = -1;
  const auto map = find_humanoid(figure.skeleton(), figure.world(), given);
  ASSERT_TRUE(map);
  EXPECT_EQ(mapped(figure.skeleton(), *map), kCaptureNames);
  EXPECT_EQ(map->doubts.size(), 5u);
  EXPECT_THAT(map->doubts, Contains(HasSubstr("map has no whole left arm")));
  EXPECT_THAT(map->doubts, Contains(HasSubstr("map has no hips above the legs")));
}

// The standing figure with meaningless names, "0", "1", …
StickFigure nameless_figure() {
  StickFigure figure = standing_figure();
  for (std::size_t i = 0; i < kCaptureNames.size(); ++i) {
    figure[kCaptureNames[i]].name = std::to_string(i);
  }
  return figure;
}

HumanoidMap asking(const StickFigure& figure,
                   std::initializer_list<std::pair<Bone, const char*>> of) {
  HumanoidMap asked;
  for (const auto& [bone, name] : of) asked[bone] = figure.skeleton().find(name);
  return asked;
}

TEST(HumanoidMap, AskedBonesGoBeforeNamesAndTheFilesOwnMap) {
  StickFigure figure = standing_figure();
  const Skeleton skeleton = figure.skeleton();
  const HumanoidMap given = given_map(figure);
  for (const HumanoidMap& file : {given, HumanoidMap{}}) {
    // a hand that is not where the names say, and the toes' name on a foot
    const HumanoidMap asked = asking(figure, {{Bone::neck, "Head"}});
    const auto map = find_humanoid(skeleton, figure.world(), file, asked);
    ASSERT_TRUE(map) << map.error().to_string();
    EXPECT_EQ(node_name(skeleton, (*map)[Bone::neck]), "Head");
    EXPECT_EQ(node_name(skeleton, (*map)[Bone::left_hand]), "LeftHand");
  }
}

TEST(HumanoidMap, AskedBoneCompletesALimbWhoseNamesDoNot) {
  StickFigure figure = standing_figure();
  figure["RightHand"].name = "Bone_17";
  const HumanoidMap asked = asking(figure, {{Bone::right_hand, "Bone_17"}});
  const auto map = find_humanoid(figure.skeleton(), figure.world(), {}, asked);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ(node_name(figure.skeleton(), (*map)[Bone::right_hand]), "Bone_17");
  EXPECT_THAT(map->doubts, IsEmpty());
}

TEST(HumanoidMap, AskedBoneTellsTheSidesOfAFigureWithoutNames) {
  const StickFigure figure = nameless_figure();
  const auto as_found = find(figure);
  ASSERT_TRUE(as_found);
  HumanoidMap asked;
  asked[Bone::left_foot] = (*as_found)[Bone::right_foot];
  asked[Bone::left_hand] = (*as_found)[Bone::right_hand];
  const auto map = find_humanoid(figure.skeleton(), figure.world(), {}, asked);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ((*map)[Bone::left_upper_leg], (*as_found)[Bone::right_upper_leg]);
  EXPECT_EQ((*map)[Bone::right_lower_arm], (*as_found)[Bone::left_lower_arm]);
}

TEST(HumanoidMap, ALegThatHangsOnTheOtherTellsNoArms) {
  StickFigure figure = standing_figure();
  figure["RightUpLeg"].parent = figure.find("LeftUpLeg");
  for (const char* side : {"Left", "Right"}) {
    for (const char* bone : {"Shoulder", "Arm", "ForeArm", "Hand"}) {
      const std::string name = std::string(side) + bone;
      if (figure.find(name) >= 0) figure[name].name = "node" + std::to_string(figure.find(name));
    }
  }
  const auto map = find(figure);
  ASSERT_FALSE(map);
  EXPECT_THAT(map.error().message, HasSubstr("arm"));
}

TEST(HumanoidMap, AskedBoneThatDoesNotHangThereIsRefused) {
  const StickFigure figure = standing_figure();
  for (const auto& [bone, name] : {std::pair(Bone::right_hand, "LeftHand"),
                                   {Bone::left_lower_leg, "Hips"},
                                   {Bone::head, "LeftFoot"},
                                   {Bone::hips, "Head"}}) {
    const auto map =
        find_humanoid(figure.skeleton(), figure.world(), {}, asking(figure, {{bone, name}}));
    ASSERT_FALSE(map) << name;
    EXPECT_THAT(map.error().message, HasSubstr(name));
    EXPECT_THAT(map.error().message, HasSubstr("does not hang where that bone does"));
  }
}

TEST(HumanoidMap, RootInTheChestIsFollowedToTheHips) {
  // the standing figure with its root at the chest: hips hang below the spine
  const StickFigure upright = standing_figure();
  StickFigure figure;
  figure.add("node0", "", upright.points[1].at);
  figure.add("node1", "node0", upright.points[0].at);
  for (std::size_t i = 2; i < upright.points.size(); ++i) {
    StickFigure::Point point = upright.points[i];
    if (point.parent == 1) {
      point.parent = 0;
    } else if (point.parent == 0) {
      point.parent = 1;
    }
    if (!point.name.empty()) point.name = "node" + std::to_string(i);
    figure.points.push_back(point);
  }
  const auto map = find(figure);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ((*map)[Bone::hips], 1);
  EXPECT_EQ((*map)[Bone::neck], 2);
  EXPECT_EQ((*map)[Bone::left_upper_leg], 5);
}

TEST(HumanoidMap, ArmsAndLegsMayLeaveOneNode) {
  StickFigure figure = standing_figure();
  for (const char* name : {"LeftShoulder", "RightShoulder", "Neck"}) figure[name].parent = 0;
  const auto map = find(figure.nameless());
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ(mapped(figure.skeleton(), *map), kCaptureNames);
  const auto headless = find(figure.without("Neck").without("Spine").nameless());
  ASSERT_TRUE(headless) << headless.error().to_string();
  EXPECT_EQ((*headless)[Bone::left_upper_leg], 1);
}

TEST(HumanoidMap, HelperAtTheHipsIsNoThigh) {
  StickFigure figure = called(
      sided("Left", "Right", {"Hips", "Neck", "Head"},
            {"@Hip", "@Knee", "@Ankle", "@Toe", "@Shoulder", "@Elbow", "@Wrist", "@Collar"}));
  for (const char* side : {"L", "R"}) {
    const std::string helper = std::string(side) + "HipJoint";
    const std::string hip = side[0] == 'L' ? "LeftHip" : "RightHip";
    const int place = figure.find(hip);
    figure.points.insert(figure.points.begin() + place, {helper, 0, figure["Hips"].at});
    for (auto& point : figure.points) {
      if (point.parent >= place) ++point.parent;
    }
    figure[hip].parent = place;
  }
  EXPECT_EQ(names_found(figure)[3], "LeftHip");
}

TEST(HumanoidMap, NeckAtThePlaceOfTheChestIsPassed) {
  StickFigure figure = standing_figure();
  figure["Neck"].name = "lowerneck";
  figure["lowerneck"].at = figure["Spine"].at;
  figure["Head"].name = "upperneck";
  figure.add("Head", "upperneck", {0, 1.62, 0});
  const auto names = names_found(figure);
  EXPECT_EQ(names[1], "upperneck");
  EXPECT_EQ(names[2], "Head");
}

// Several hinges of one joint share its name, as in MuJoCo's bodies.
TEST(HumanoidMap, OfJointsAtOnePointOneThatEndsASegmentIsTheBone) {
  StickFigure figure = standing_figure();
  StickFigure hinges;
  for (const StickFigure::Point& point : figure.points) {
    const std::string parent =
        point.parent < 0 ? "" : figure.points[static_cast<std::size_t>(point.parent)].name;
    const bool limb = point.name.starts_with("Left") || point.name.starts_with("Right");
    if (limb) {
      hinges.add(point.name + "_x", parent, point.at);
      hinges.add(point.name, point.name + "_x", point.at);
    } else {
      hinges.add(point.name, parent, point.at);
    }
  }
  // SOMA's names: the leg is the thigh
  for (StickFigure::Point& point : hinges.points) {
    if (const std::size_t at = point.name.find("UpLeg"); at != std::string::npos) {
      point.name.erase(at, 2);
    } else if (const std::size_t leg = point.name.find("Leg"); leg != std::string::npos) {
      point.name.replace(leg, 3, "Shin");
    }
  }
  const auto map = find(hinges);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ((*map)[Bone::left_upper_leg], hinges.find("LeftLeg_x"));
  EXPECT_EQ((*map)[Bone::left_lower_leg], hinges.find("LeftShin_x"));
  EXPECT_EQ((*map)[Bone::left_foot], hinges.find("LeftFoot_x"));
  EXPECT_EQ((*map)[Bone::right_hand], hinges.find("RightHand_x"));
}

// A robot's forearm turns at its elbow, by a joint named after the wrist.
TEST(HumanoidMap, NamesYieldWhereASegmentHasHardlyAnyLength) {
  StickFigure figure = standing_figure();
  for (const char* side : {"Left", "Right"}) {
    const std::string hand = side + std::string("Hand");
    const Vec3d elbow = figure[side + std::string("ForeArm")].at;
    const Vec3d out{side[0] == 'L' ? 0.02 : -0.02, 0, 0};
    figure[hand].at = elbow + out;
    figure.add(side + std::string("HandPitch"), hand, elbow + out * 12.0);
  }
  const auto map = find(figure);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ((*map)[Bone::left_hand], figure.find("LeftHandPitch"));
}

TEST(HumanoidMap, NeckWithoutANameIsTheJointBelowTheHead) {
  StickFigure figure = standing_figure();
  figure["Neck"].name = "Bone";
  EXPECT_EQ(names_found(figure)[1], "Bone");
}

TEST(HumanoidMap, MissingNeckHeadAndToesAreDoubts) {
  const StickFigure figure = standing_figure().without("Neck").without("LeftToeBase");
  const auto map = find(figure);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ((*map)[Bone::neck], -1);
  EXPECT_EQ((*map)[Bone::head], -1);
  EXPECT_EQ((*map)[Bone::left_toes], -1);
  EXPECT_THAT(map->doubts, Contains(HasSubstr("no neck joint")));
  EXPECT_THAT(map->doubts, Contains(HasSubstr("no head joint")));
  EXPECT_THAT(map->doubts, Contains(HasSubstr("no left_toes: below joint 'LeftFoot'")));
}

TEST(HumanoidMap, MirroredFileIsADoubt) {
  const auto map = find(standing_figure().transformed({{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  ASSERT_TRUE(map);
  EXPECT_EQ((*map)[Bone::left_upper_leg], 5);
  EXPECT_THAT(map->doubts, Contains(HasSubstr("feet point backwards")));
}

TEST(HumanoidMap, BodyWithoutLegsIsRefused) {
  const StickFigure figure = standing_figure().without("LeftUpLeg").without("RightUpLeg");
  EXPECT_THAT(error_of(figure), HasSubstr("no left leg: joint 'Hips' has no chains that go down"));
  EXPECT_THAT(error_of(figure.nameless()), HasSubstr("no two legs and two arms"));
}

TEST(HumanoidMap, BodyWithOneLegIsRefused) {
  const StickFigure figure = standing_figure().without("RightUpLeg");
  EXPECT_EQ(error_of(figure),
            "no right leg: joint 'Hips' has 1 chain that goes down: joint 'LeftUpLeg'");
}

TEST(HumanoidMap, BodyWithoutArmsIsRefused) {
  const StickFigure figure = standing_figure().without("LeftShoulder").without("RightShoulder");
  EXPECT_THAT(error_of(figure), HasSubstr("no left arm: joint 'Hips' has 3 chains"));
}

TEST(HumanoidMap, BodyWithOneArmIsRefused) {
  const StickFigure figure = standing_figure().without("RightShoulder");
  EXPECT_EQ(error_of(figure),
            "no right arm: joint 'Spine' has 2 chains: joint 'Neck', joint 'LeftShoulder'");
}

TEST(HumanoidMap, LegWithoutFootIsRefusedByName) {
  EXPECT_EQ(error_of(standing_figure().without("RightFoot")),
            "no right_foot: below joint 'RightLeg' nothing follows");
  StickFigure figure = standing_figure().without("RightFoot");
  figure.add("", "RightLeg", {-0.085, 0.1, 0});
  EXPECT_EQ(error_of(figure),
            "no right_foot: below joint 'RightLeg' comes only the End Site of 'RightLeg'");
}

TEST(HumanoidMap, StickOfTwoNodesIsRefused) {
  StickFigure figure;
  figure.add("a", "", {});
  figure.add("b", "a", {0, 1, 0});
  EXPECT_EQ(error_of(figure), "no left leg: joint 'a' has no chains that go down");
}

TEST(HumanoidMap, BodyWithoutLengthIsRefused) {
  EXPECT_EQ(error_of(standing_figure().transformed({{}, {}, {}})),
            "no skeleton in this file: its 25 nodes stand at one point");
}

TEST(HumanoidMap, EmptySkeletonIsRefused) {
  EXPECT_EQ(error_of(StickFigure()), "no body: there are no nodes");
}

TEST(HumanoidMap, LimbsOnSeveralRootsAreRefused) {
  StickFigure figure = standing_figure();
  figure["LeftUpLeg"].parent = -1;
  EXPECT_EQ(error_of(figure), "no hips: the limbs hang on several roots");
}

struct RealBody {
  const char* path;
  std::vector<std::string> names;
};

class RealBodies : public ::testing::TestWithParam<RealBody> {
 protected:
  void SetUp() override {
    const fs::path path = fs::path(SHIGUSA_SHARED_DIR) / GetParam().path;
    if (!fs::exists(path)) GTEST_SKIP() << "no " << path;
    auto motion = read_bvh(path);
    ASSERT_TRUE(motion) << motion.error().to_string();
    motion_ = std::move(*motion);
  }
  // the patterns also name the collar bones
  [[nodiscard]] static std::vector<std::string> expected() {
    return {GetParam().names.begin(), GetParam().names.begin() + kLimbBones};
  }
  SkeletonMotion motion_;
};

TEST_P(RealBodies, AreMappedByTheirNamesInEveryFrame) {
  for (int frame = 0; frame < motion_.clip.frames; frame += 10) {
    const auto world = world_transforms(motion_.skeleton, motion_.clip, frame);
    const auto map = find_humanoid(motion_.skeleton, world);
    ASSERT_TRUE(map) << map.error().to_string();
    EXPECT_EQ(mapped(motion_.skeleton, *map), expected());
    EXPECT_THAT(map->doubts, IsEmpty()) << frame;
  }
}

// The names are the oracle for the shape.
TEST_P(RealBodies, AreMappedTheSameWithoutNames) {
  Skeleton nameless = motion_.skeleton;
  for (std::size_t i = 0; i < nameless.nodes.size(); ++i) {
    if (!nameless.nodes[i].end_site) nameless.nodes[i].name = "node" + std::to_string(i);
  }
  const auto world = world_transforms(nameless, motion_.clip, 0);
  const auto map = find_humanoid(nameless, world);
  ASSERT_TRUE(map) << map.error().to_string();
  EXPECT_EQ(mapped(motion_.skeleton, *map), expected());
}

const std::vector<std::string> kHahneNames{
    "Hips",      "Neck",      "Head",          "LeftHip",    "LeftKnee",  "LeftAnkle",
    "LeftToe",   "RightHip",  "RightKnee",     "RightAnkle", "RightToe",  "LeftShoulder",
    "LeftElbow", "LeftWrist", "RightShoulder", "RightElbow", "RightWrist"};

std::vector<std::string> with(std::vector<std::string> names, const std::string& from,
                              const std::string& to) {
  for (std::string& name : names) {
    const std::size_t at = name.find(from);
    if (at != name.npos) name.replace(at, from.size(), to);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(
    Shared, RealBodies,
    ::testing::Values(
        RealBody{"characters/assimp__Boxing_Toes.bvh", with(kHahneNames, "Toe", "Toes")},
        RealBody{"characters/blender-cli-rendering__102_01.bvh", kHahneNames},
        RealBody{"characters/fairmotion__pfnn_hierarchy.bvh", with(kCaptureNames, "Neck", "Neck1")},
        RealBody{"characters/pybvh__bvh_test1.bvh", kCaptureNames},
        RealBody{"characters/pybvh__standard_skeleton.bvh", kCaptureNames},
        RealBody{"reach/cmu_02_06_60hz.bvh",
                 sided("l", "r", {"root", "lowerneck", "head"},
                       {"@femur", "@tibia", "@foot", "@toes", "@humerus", "@radius", "@wrist",
                        "@clavicle"})}),
    [](const auto& test) {
      std::string name = fs::path(test.param.path).stem().string();
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
      return name;
    });

std::vector<std::string> spine_of(const StickFigure& figure, const HumanoidMap& given = {}) {
  const auto map = find_humanoid(figure.skeleton(), figure.world(), given);
  EXPECT_TRUE(map);
  std::vector<std::string> names;
  for (const Bone bone : {Bone::spine, Bone::chest, Bone::upper_chest}) {
    names.push_back(node_name(figure.skeleton(), (*map)[bone]));
  }
  return names;
}

// The standing figure with joints at these heights (m) above its hips instead of its single one.
StickFigure with_spine(const std::vector<double>& heights) {
  const StickFigure one = standing_figure();
  StickFigure figure;
  for (const StickFigure::Point& point : one.points) {
    if (point.name != "Spine") {
      const std::string parent =
          point.parent < 0 ? "" : one.points[static_cast<std::size_t>(point.parent)].name;
      figure.add(point.name, parent == "Spine" ? "S" + std::to_string(heights.size()) : parent,
                 point.at);
      continue;
    }
    for (std::size_t j = 0; j < heights.size(); ++j) {
      const Vec3d at = one.points[0].at + Vec3d{0.0, heights[j], 0.0};
      figure.add("S" + std::to_string(j + 1), j == 0 ? "Hips" : "S" + std::to_string(j), at);
    }
  }
  return figure;
}

TEST(SpineBones, AreTheJointsBetweenHipsAndArmsFromBelow) {
  using testing::ElementsAre;
  EXPECT_THAT(spine_of(with_spine({0.2})), ElementsAre("S1", "-", "-"));
  EXPECT_THAT(spine_of(with_spine({0.1, 0.3})), ElementsAre("S1", "S2", "-"));
  EXPECT_THAT(spine_of(with_spine({0.1, 0.2, 0.3})), ElementsAre("S1", "S2", "S3"));
}

TEST(SpineBones, OfManyAreThoseAtThePlacesOfThree) {
  // the way to the neck is 0.56 m: the shares 0.17, 0.47 and 0.72 are at 0.10, 0.26 and 0.40 m
  EXPECT_THAT(spine_of(with_spine({0.02, 0.11, 0.21, 0.33, 0.41, 0.48})),
              testing::ElementsAre("S2", "S3", "S5"));
}

TEST(SpineBones, GoByTheFilesOwnMapWhereItIsAChain) {
  const StickFigure figure = with_spine({0.1, 0.2, 0.3});
  HumanoidMap given;
  given[Bone::spine] = figure.find("S1");
  given[Bone::chest] = figure.find("S3");
  EXPECT_THAT(spine_of(figure, given), testing::ElementsAre("S1", "S3", "-"));
  std::swap(given[Bone::spine], given[Bone::chest]);
  EXPECT_THAT(spine_of(figure, given), testing::ElementsAre("S1", "S2", "S3"));
}

TEST(SpineBones, ShouldersAreTheJointsBeforeTheUpperArms) {
  const StickFigure figure = standing_figure();
  const HumanoidMap map = find(figure).value();
  EXPECT_EQ(map[Bone::left_shoulder], figure.find("LeftShoulder"));
  EXPECT_EQ(map[Bone::right_shoulder], figure.find("RightShoulder"));
}

TEST(SpineBones, AreMeasuredAsJointsOfThePerson) {
  const StickFigure figure = with_spine({0.1, 0.3});
  const HumanoidMap map = find(figure).value();
  const Landmarks person = measure_person(figure.skeleton(), figure.world(), map)->landmarks;
  ASSERT_EQ(person.spine.size(), 2u);
  const double hips = person.left_leg.hip.y;
  EXPECT_NEAR(person.spine[0].y - hips, 0.1, 1e-9);
  EXPECT_NEAR(person.spine[1].y - hips, 0.3, 1e-9);
  ASSERT_TRUE(person.head && person.left_arm.clavicle && person.right_arm.clavicle);
  EXPECT_NEAR(person.left_arm.clavicle->x, 0.02, 1e-9);
  EXPECT_NEAR(person.head->y - person.neck.y, 0.1, 1e-9);
}

}  // namespace
}  // namespace shigusa
