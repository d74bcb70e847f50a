// SPDX-License-Identifier: MIT
#include "robot_columns.hpp"

#include <fmt/format.h>

#include <array>
#include <shigusa/quat.hpp>
#include <utility>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {
namespace {

constexpr std::array kPoseNames{"root.x [m]", "root.y [m]", "root.z [m]", "root.qx",
                                "root.qy",    "root.qz",    "root.qw"};

// Where the root link is in each frame.
void add_root(const BodyModel& body, const Clip& clip, std::vector<CsvColumn>& columns) {
  const RobotFrame& robot = *body.robot();
  std::array<CsvColumn, kPoseNames.size()> pose;
  for (std::size_t k = 0; k < pose.size(); ++k) pose[k].name = kPoseNames[k];
  Kinematics<double> kinematics(body);
  Quatd before;
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), kinematics);
    const Mat3d r = kinematics.link_rotation(robot.link) * robot.root_in_link.rotation;
    const Mat3d turned{in_robot_world(r.cx), in_robot_world(r.cy), in_robot_world(r.cz)};
    const Vec3d at = in_robot_world(kinematics.point(robot.link, robot.root_in_link.translation));
    const Quatd q = before = nearer(to_quat(turned), before);
    const double values[] = {at.x, at.y, at.z, q.x, q.y, q.z, q.w};
    for (std::size_t k = 0; k < pose.size(); ++k) pose[k].values.push_back(values[k]);
  }
  for (CsvColumn& column : pose) columns.push_back(std::move(column));
}

}  // namespace

Vec3d in_robot_world(const Vec3d& point) { return {point.z, point.x, point.y}; }

void add_robot_columns(const BodyModel& body, const Motion& motion,
                       std::vector<CsvColumn>& columns) {
  const Clip& clip = motion.clip;
  add_root(body, clip, columns);
  const auto dofs = static_cast<std::size_t>(clip.dofs);
  const auto of_dof = [&](const RobotJoint& joint, const std::vector<double>& all) {
    std::vector<double> values;
    for (std::size_t i = static_cast<std::size_t>(joint.dof); i < all.size(); i += dofs) {
      values.push_back(0.0 + joint.sign * all[i]);  // no -0
    }
    return values;
  };
  const auto frames = static_cast<std::size_t>(clip.frames);
  for (const RobotJoint& joint : body.robot()->joints) {
    columns.push_back(
        {joint.name + (joint.slides ? " [m]" : " [rad]"),
         joint.dof < 0 ? std::vector<double>(frames, joint.angle) : of_dof(joint, clip.angles)});
  }
  for (const RobotJoint& joint : body.robot()->joints) {
    if (joint.dof < 0) continue;
    columns.push_back({joint.name + " torque [N m]", of_dof(joint, motion.torques)});
  }
}

}  // namespace shigusa
