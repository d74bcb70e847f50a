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

// A robot in shigusa's world, standing with every angle at 0; the floor is not known yet, so y is
// from between the ankles.
struct PlacedRobot {
  std::vector<Transformd> links;  // (links) X_WL
  std::vector<Vec3d> axis;        // (joints) unit vector: the child turns about it, world
  std::vector<int> carrier;       // (links) the joint that a link hangs on; -1: the root
  // (links) joints that hang on the link
  std::vector<std::vector<int>> below;

  [[nodiscard]] const Vec3d& centre(const Robot& robot, int joint) const {
    const int child = robot.joints[index(joint)].child;
    return links[index(child)].translation;
  }
};

// Stands the robot up by its map: y up, facing +z. Fails where its up or its left is not clear.
[[nodiscard]] Result<PlacedRobot> place_robot(const Robot& robot, const HumanoidMap& map);

// A joint of the file as one of a person.
struct PersonJoint {
  int joint = -1;         // of the robot's joints
  bool outward = true;    // the child is the side away from the pelvis
  std::string part{};     // "right_knee"
  std::string freedom{};  // "flexion"; the joint's own name where none fits
  double sign = 1.0;      // the freedom's angle is sign · that of the file
  // rad, a person's limits in terms of the freedom, less what the start posture has of it already
  std::optional<std::array<double, 2>> usual{};
};

// The joints of a limb from the pelvis outwards, and where it ends.
struct PersonLimb {
  std::vector<PersonJoint> joints;
  int end = -1;  // the outermost link that these move
  // places in `joints` where the parts begin: hip 0, knee, ankle; or clavicle, shoulder, elbow,
  // wrist, which follow the spine
  std::vector<std::size_t> begins;
};

struct PersonJoints {
  int pelvis = -1;                 // link
  int chest = -1;                  // link where the arms leave
  std::vector<PersonJoint> spine;  // from the pelvis to the chest
  std::vector<PersonJoint> neck;   // from the chest to the head
  std::array<PersonLimb, 2> legs;  // left, right
  std::array<PersonLimb, 2> arms;  // without the spine
};

// Finds them; fails where a limb lacks a turning joint for one of its parts.
[[nodiscard]] Result<PersonJoints> person_joints(const Robot& robot, const HumanoidMap& map,
                                                 const PlacedRobot& placed);

}  // namespace shigusa
