// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/human.hpp>
#include <string>
#include <vector>

#include "core/index.hpp"
#include "robot/robot.hpp"

namespace shigusa {

// A robot in shigusa's world, standing at zero angles. The floor is unknown at this point, so y is
// measured from mid-ankle.
struct PlacedRobot {
  std::vector<Transformd> links;  // (links) X_WL
  std::vector<Vec3d> axis;        // (joints) unit vector: the child turns about it, world
  std::vector<int> carrier;       // (links) joint to the parent; -1: the root
  // (links) joints to children
  std::vector<std::vector<int>> below;

  [[nodiscard]] const Vec3d& centre(const Robot& robot, int joint) const {
    const int child = robot.joints[index(joint)].child;
    return links[index(child)].translation;
  }
};

// Orients the robot by its bone map: y up, facing +z. Fails if its up or its left is ambiguous.
[[nodiscard]] Result<PlacedRobot> place_robot(const Robot& robot, const HumanoidMap& map);

// A joint of the file in the role of a person's joint.
struct PersonJoint {
  int joint = -1;         // of the robot's joints
  bool outward = true;    // the child is the side away from the pelvis
  std::string part{};     // "right_knee"
  std::string freedom{};  // "flexion"; the joint's own name if none fits
  double sign = 1.0;      // the human angle is sign · that of the file
  // rad, a person's limits of the degree of freedom, relative to the start posture
  std::optional<std::array<double, 2>> usual{};
};

// Joints of a limb from the pelvis outwards, and its end.
struct PersonLimb {
  std::vector<PersonJoint> joints;
  int end = -1;  // outermost link moved by these
  // indices in `joints` where the parts begin: hip 0, knee, ankle; or clavicle, shoulder, elbow,
  // wrist, which follow the spine
  std::vector<std::size_t> begins;
};

struct PersonJoints {
  int pelvis = -1;                 // link
  int chest = -1;                  // common ancestor of the arms
  std::vector<PersonJoint> spine;  // from the pelvis to the chest
  std::vector<PersonJoint> neck;   // from the chest to the head
  std::array<PersonLimb, 2> legs;  // left, right
  std::array<PersonLimb, 2> arms;  // without the spine
};

// Finds a person's joints in a robot; fails if a limb lacks a turning joint for one of its parts.
[[nodiscard]] Result<PersonJoints> person_joints(const Robot& robot, const HumanoidMap& map,
                                                 const PlacedRobot& placed);

}  // namespace shigusa
