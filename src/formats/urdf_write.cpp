// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iterator>

#include "core/index.hpp"
#include "formats/urdf.hpp"

namespace shigusa {
namespace {

std::string numbers(const Vec3d& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

// Roll, pitch and yaw: R = Rz(yaw) Ry(pitch) Rx(roll). The yaw is removed before the others are
// computed, so that at a pitch of 90° the three still determine R to the last digits.
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

// Writes a shape as "collision" or "visual"; nothing for a shape without a size.
std::string element(const char* name, const Robot::Shape& shape) {
  using Kind = Robot::Shape::Kind;
  const Vec3d& half = shape.half;
  if (!(half.x > 0.0) || !(half.y > 0.0) || !(half.z > 0.0)) return {};
  std::string geometry;
  switch (shape.kind) {
    case Kind::box:
      geometry = fmt::format("<box size=\"{}\"/>", numbers(half * 2.0));
      break;
    case Kind::cylinder:
      geometry = fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", half.x, 2.0 * half.z);
      break;
    case Kind::ball:
      geometry = fmt::format("<sphere radius=\"{}\"/>", half.x);
      break;
  }
  return fmt::format("<{0}>{1}<geometry>{2}</geometry></{0}>", name, origin(shape.place), geometry);
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
  for (const Robot::Shape& shape : link.collides) text += element("collision", shape);
  for (const Robot::Shape& shape : link.shown) text += element("visual", shape);
  text += "</link>\n";
}

void write_joint(const Robot& robot, const Robot::Joint& joint, std::string& text) {
  const auto out = std::back_inserter(text);
  // such limits mark a joint with a single possible angle
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

void write_state(const Robot::Keyframe& frame, std::string& text) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<group_state name=\"{}\">", xml_escaped(frame.name));
  for (const auto& [joint, angle] : frame.angles) {
    fmt::format_to(out, "<joint name=\"{}\" value=\"{}\"/>", xml_escaped(joint), angle);
  }
  text += "</group_state>\n";
}

}  // namespace

std::string write_urdf(const Robot& robot) {
  std::string text = fmt::format("<robot name=\"{}\">\n", xml_escaped(robot.name));
  for (const Robot::Link& link : robot.links) write_link(link, text);
  for (const Robot::Joint& joint : robot.joints) write_joint(robot, joint, text);
  for (const Robot::Keyframe& frame : robot.keyframes) write_state(frame, text);
  return text + "</robot>\n";
}

}  // namespace shigusa
