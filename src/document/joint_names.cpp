// SPDX-License-Identifier: MIT
#include "joint_names.hpp"

#include <algorithm>
#include <array>

namespace shigusa {
namespace {

// Names of the bones. The three spine joints correspond to all three of Mixamo, the first three of
// HumanIK, and the three of Unreal's first mannequin.
constexpr std::array<JointNameRow, 22> kRows{{
    {"hips", "mixamorig:Hips", "pelvis", "Hips"},
    {"spine", "mixamorig:Spine", "spine_01", "Spine"},
    {"chest", "mixamorig:Spine1", "spine_02", "Spine1"},
    {"upper_chest", "mixamorig:Spine2", "spine_03", "Spine2"},
    {"neck", "mixamorig:Neck", "neck_01", "Neck"},
    {"head", "mixamorig:Head", "head", "Head"},
    {"left_shoulder", "mixamorig:LeftShoulder", "clavicle_l", "LeftShoulder"},
    {"left_upper_arm", "mixamorig:LeftArm", "upperarm_l", "LeftArm"},
    {"left_lower_arm", "mixamorig:LeftForeArm", "lowerarm_l", "LeftForeArm"},
    {"left_hand", "mixamorig:LeftHand", "hand_l", "LeftHand"},
    {"right_shoulder", "mixamorig:RightShoulder", "clavicle_r", "RightShoulder"},
    {"right_upper_arm", "mixamorig:RightArm", "upperarm_r", "RightArm"},
    {"right_lower_arm", "mixamorig:RightForeArm", "lowerarm_r", "RightForeArm"},
    {"right_hand", "mixamorig:RightHand", "hand_r", "RightHand"},
    {"left_upper_leg", "mixamorig:LeftUpLeg", "thigh_l", "LeftUpLeg"},
    {"left_lower_leg", "mixamorig:LeftLeg", "calf_l", "LeftLeg"},
    {"left_foot", "mixamorig:LeftFoot", "foot_l", "LeftFoot"},
    {"left_toes", "mixamorig:LeftToeBase", "ball_l", "LeftToeBase"},
    {"right_upper_leg", "mixamorig:RightUpLeg", "thigh_r", "RightUpLeg"},
    {"right_lower_leg", "mixamorig:RightLeg", "calf_r", "RightLeg"},
    {"right_foot", "mixamorig:RightFoot", "foot_r", "RightFoot"},
    {"right_toes", "mixamorig:RightToeBase", "ball_r", "RightToeBase"},
}};

}  // namespace

std::span<const JointNameRow> joint_name_rows() { return kRows; }

std::string_view joint_name(JointNames names, std::string_view own) {
  const auto row = std::find_if(kRows.begin(), kRows.end(),
                                [&](const JointNameRow& known) { return known[0] == own; });
  return row == kRows.end() ? own : (*row)[static_cast<std::size_t>(names)];
}

Skeleton named(Skeleton skeleton, JointNames names) {
  for (SkeletonNode& node : skeleton.nodes) node.name = joint_name(names, node.name);
  return skeleton;
}

}  // namespace shigusa
