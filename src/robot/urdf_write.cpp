// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iterator>

#include "core/index.hpp"
#include "robot/urdf.hpp"

namespace shigusa {
namespace {

std::string numbers(const Vec3d& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

// Roll, pitch and yaw: R = Rz(yaw) Ry(pitch) Rx(roll). The yaw is taken out before the others are
// read, so that where the pitch is a right angle the three still tell R to the last digits.
Vec3d roll_pitch_yaw(const Mat3d& r) {
  const double yaw = atan2(r.cx.y, r.cx.x);
  const SinCos<double> turn = sin_cos(yaw);
  const double pitch = atan2(-r.cx.z, turn.cos * r.cx.x + turn.sin * r.cx.y);
  const double roll =
      atan2(turn.sin * r.cz.x - turn.cos * r.cz.y, turn.cos * r.cy.y - turn.sin * r.cy.x);
  return {roll, pitch, yaw};
}

std::string origin(const Transformd& x) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", numbers(x.translation),
                     numbers(roll_pitch_yaw(x.rotation)));
}

// The box that eight corners of a link are of, as box_corners numbers them.
std::string box(const Vec3d* corners) {
  const Vec3d x = corners[1] - corners[0];
  const Vec3d y = corners[2] - corners[0];
  const Vec3d z = corners[4] - corners[0];
  const Vec3d size{norm(x), norm(y), norm(z)};
  if (!(size.x > 0.0) || !(size.y > 0.0) || !(size.z > 0.0)) return {};
  const Transformd place{{x * (1.0 / size.x), y * (1.0 / size.y), z * (1.0 / size.z)},
                         (corners[0] + corners[7]) * 0.5};
  return fmt::format("<collision>{}<geometry><box size=\"{}\"/></geometry></collision>",
                     origin(place), numbers(size));
}

void write_link(const Robot::Link& link, std::string& text) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<link name=\"{}\">", xml_escaped(link.name));
  if (link.mass > 0.0) {
    const Mat3d& i = link.inertia;
    fmt::format_to(out,
                   "<inertial><origin xyz=\"{}\"/><mass value=\"{}\"/><inertia ixx=\"{}\" "
                   "ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/></inertial>",
                   numbers(link.com), link.mass, i.cx.x, i.cx.y, i.cx.z, i.cy.y, i.cy.z, i.cz.z);
  }
  for (std::size_t k = 0; k + 8 <= link.corners.size(); k += 8) text += box(&link.corners[k]);
  text += "</link>\n";
}

void write_joint(const Robot& robot, const Robot::Joint& joint, std::string& text) {
  const auto out = std::back_inserter(text);
  // limits tell a joint that can be at one angle only
  const bool rigid = joint.limited && joint.upper - joint.lower < 1e-6;
  const bool follows = joint.moves && !joint.slides && !joint.turns && !rigid;
  const char* type = !joint.moves               ? "fixed"
                     : joint.slides             ? "prismatic"
                     : joint.limited || follows ? "revolute"
                                                : "continuous";
  const auto name = [&](int link) { return xml_escaped(robot.links[index(link)].name); };
  fmt::format_to(out, "<joint name=\"{}\" type=\"{}\"><parent link=\"{}\"/><child link=\"{}\"/>{}",
                 xml_escaped(joint.name), type, name(joint.parent), name(joint.child),
                 origin(joint.origin));
  if (joint.moves) {
    fmt::format_to(out,
                   "<axis xyz=\"{}\"/><limit lower=\"{}\" upper=\"{}\" effort=\"{}\" "
                   "velocity=\"0\"/>",
                   numbers(joint.axis), joint.lower, joint.upper, joint.effort);
  }
  if (follows) fmt::format_to(out, "<mimic joint=\"{}\"/>", xml_escaped(joint.name));
  text += "</joint>\n";
}

}  // namespace

std::string write_urdf(const Robot& robot) {
  std::string text = fmt::format("<robot name=\"{}\">\n", xml_escaped(robot.name));
  for (const Robot::Link& link : robot.links) write_link(link, text);
  for (const Robot::Joint& joint : robot.joints) write_joint(robot, joint, text);
  return text + "</robot>\n";
}

}  // namespace shigusa
