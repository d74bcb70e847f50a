// SPDX-License-Identifier: MIT
#include "rig_drivers.hpp"

#include <string>

#include "body/joint_name.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

Transformd segment(const Mat3d& frame, const Vec3d& joint, const Vec3d& far) {
  return {along_segment(frame, joint, far), joint};
}

// A bone's segment in one posture: its orientation and its proximal joint.
Transformd segment(Bone bone, const Landmarks& person, const HumanFrames& frames) {
  const Landmarks::Leg& left_leg = person.left_leg;
  const Landmarks::Leg& right_leg = person.right_leg;
  const Landmarks::Arm& left_arm = person.left_arm;
  const Landmarks::Arm& right_arm = person.right_arm;
  switch (bone) {
    case Bone::left_upper_leg:
      return segment(frames.left_leg.thigh, left_leg.hip, left_leg.knee);
    case Bone::right_upper_leg:
      return segment(frames.right_leg.thigh, right_leg.hip, right_leg.knee);
    case Bone::left_lower_leg:
      return segment(frames.left_leg.shank, left_leg.knee, left_leg.ankle);
    case Bone::right_lower_leg:
      return segment(frames.right_leg.shank, right_leg.knee, right_leg.ankle);
    case Bone::left_foot:
    case Bone::left_toes:
      return {frames.left_leg.foot, left_leg.ankle};
    case Bone::right_foot:
    case Bone::right_toes:
      return {frames.right_leg.foot, right_leg.ankle};
    case Bone::left_upper_arm:
      return segment(frames.left_arm.upper_arm, left_arm.shoulder, left_arm.elbow);
    case Bone::right_upper_arm:
      return segment(frames.right_arm.upper_arm, right_arm.shoulder, right_arm.elbow);
    case Bone::left_lower_arm:
    case Bone::left_hand:
      return segment(frames.left_arm.forearm, left_arm.elbow, left_arm.wrist);
    case Bone::right_lower_arm:
    case Bone::right_hand:
      return segment(frames.right_arm.forearm, right_arm.elbow, right_arm.wrist);
    default:
      return {frames.trunk, (left_leg.hip + right_leg.hip) * 0.5};
  }
}

}  // namespace

std::optional<BoneDriver> bone_driver(Bone bone, const BodyModel& body, const Rig& rig,
                                      const HumanFrames& rest, const HumanFrames& start) {
  const Transformd to_start =
      segment(bone, rig.start, start) * inverse(segment(bone, rig.rest, rest));
  const bool left_leg = bone >= Bone::left_upper_leg && bone <= Bone::left_toes;
  // a half body's left leg moves with its right one
  const bool half = left_leg && body.find_node(humanoid_bone_name(Bone::left_lower_leg)) == nullptr;
  const std::string name(humanoid_bone_name(bone));
  const BodyNode* node = body.find_node(half ? with_other_side(name) : name);
  if (node == nullptr) return std::nullopt;
  return BoneDriver{node->link, to_start, !half};
}

std::vector<Transformd> at_rest(const Rig& rig) {
  std::vector<Transformd> world;
  std::vector<Transformd> turned;
  for (const RigNode& node : rig.nodes) {
    const Mat3d r = to_matrix(node.rotation);
    const Vec3d& s = node.scale;
    const Transformd local{{r.cx * s.x, r.cy * s.y, r.cz * s.z}, node.translation};
    if (node.parent < 0) {
      world.push_back(local);
      turned.push_back({r, {}});
      continue;
    }
    const auto parent = static_cast<std::size_t>(node.parent);
    world.push_back(world[parent] * local);
    turned.push_back({turned[parent].rotation * r, {}});
  }
  for (std::size_t i = 0; i < world.size(); ++i) world[i].rotation = turned[i].rotation;
  return world;
}

}  // namespace shigusa
