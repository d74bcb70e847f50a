// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

// A small robot as URDF: 25 turning limb joints, slanting axes in hips and shoulders, a waist of
// two joints, a mimicking finger, a sliding drawer, soles as boxes, hands as fixed frames. Joints
// and links have names that are usual for robots; it faces x, z up.
namespace shigusa::testing_support {

class RobotFile {
 public:
  // `hands`: else the arms end at the elbows
  explicit RobotFile(bool hands = true) : hands_(hands) {
    link("pelvis", 6.0, "0 0 0.05");
    for (const char* side : {"left", "right"}) add_leg(side, side[0] == 'l' ? 1.0 : -1.0);
    joint("waist_yaw", "pelvis", "waist", "0 0 0.1", "0 0 0", "0 0 1", -1.2, 1.2, 90);
    link("waist", 1.0, "0 0 0.03");
    joint("waist_pitch", "waist", "torso", "0 0 0.05", "0 0 0", "0 1 0", -0.4, 1.0, 120);
    link("torso", 12.0, "0.01 0 0.15");
    for (const char* side : {"left", "right"}) add_arm(side, side[0] == 'l' ? 1.0 : -1.0);
    joint("neck_yaw", "torso", "head", "0 0 0.38", "0 0 0", "0 0 1", -1.0, 1.0, 5);
    link("head", 2.0, "0 0 0.1");
    body_ +=
        "<joint name=\"drawer\" type=\"prismatic\"><parent link=\"torso\"/><child link=\"tray\"/>"
        "<axis xyz=\"1 0 0\"/><limit lower=\"0.05\" upper=\"0.2\" effort=\"5\" velocity=\"1\"/>"
        "</joint>";
    link("tray", 0.2, "0 0 0");
  }

  [[nodiscard]] std::string text() const {
    return "<?xml version=\"1.0\"?>\n<!-- a robot -->\n<robot name=\"small\">\n" + body_ +
           "</robot>\n";
  }

 private:
  void link(const std::string& name, double mass, const char* com, const char* sole = "") {
    const double i = 0.01 * mass;
    body_ += fmt::format(
        "<link name=\"{}\"><inertial><origin xyz=\"{}\" rpy=\"0.1 0.2 0\"/><mass value=\"{}\"/>"
        "<inertia ixx=\"{}\" ixy=\"{}\" ixz=\"0\" iyy=\"{}\" iyz=\"0\" izz=\"{}\"/></inertial>"
        "<visual><geometry><mesh filename=\"package://none/{}.stl\"/></geometry></visual>{}"
        "</link>\n",
        name, com, mass, i, 0.1 * i, 1.2 * i, 0.7 * i, name, sole);
  }

  void joint(const std::string& name, const std::string& parent, const std::string& child,
             const std::string& xyz, const std::string& rpy, const std::string& axis, double lower,
             double upper, double effort) {
    body_ += fmt::format(
        "<joint name=\"{}\" type=\"revolute\"><parent link=\"{}\"/><child link=\"{}\"/>"
        "<origin xyz=\"{}\" rpy=\"{}\"/><axis xyz=\"{}\"/>"
        "<limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"10\"/></joint>\n",
        name, parent, child, xyz, rpy, axis, lower, upper, effort);
  }

  void add_leg(const std::string& side, double s) {
    const std::string p = side + "_";
    joint(p + "hip_yaw", "pelvis", p + "hip_1", fmt::format("0 {} -0.05", 0.08 * s),
          fmt::format("{} 0 0", 0.2 * s), "0 0 1", -0.8, 0.8, 60);
    link(p + "hip_1", 1.0, "0 0 -0.02");
    joint(p + "hip_roll", p + "hip_1", p + "hip_2", "0 0 -0.03", "0 0 0", "1 0 0", -0.5, 0.5, 90);
    link(p + "hip_2", 1.0, "0 0 -0.02");
    joint(p + "hip_pitch", p + "hip_2", p + "thigh", "0 0 0", fmt::format("{} 0 0", -0.2 * s),
          "0 1 0", -2.0, 0.6, 110);
    link(p + "thigh", 3.0, "0 0 -0.15");
    // this one turns the other way round
    joint(p + "knee", p + "thigh", p + "shank", "0 0 -0.3", "0 0 0", "0 -1 0", -2.3, 0.0, 120);
    link(p + "shank", 2.0, "0 0 -0.12");
    joint(p + "ankle_pitch", p + "shank", p + "ankle", "0 0 -0.3", "0 0 0", "0 1 0", -0.9, 0.7, 80);
    link(p + "ankle", 0.2, "0 0 0");
    joint(p + "ankle_roll", p + "ankle", p + "sole", "0 0 -0.01", "0 0 0", "1 0 0", -0.4, 0.4, 50);
    link(p + "sole", 0.8, "0.03 0 -0.03",
         "<collision><origin xyz=\"0.03 0 -0.04\"/><geometry><box size=\"0.2 0.1 0.02\"/>"
         "</geometry></collision>");
  }

  void add_arm(const std::string& side, double s) {
    const std::string p = side + "_";
    joint(p + "shoulder_pitch", "torso", p + "shoulder_1", fmt::format("0 {} 0.3", 0.16 * s),
          fmt::format("{} 0 0", 0.3 * s), "0 1 0", -3.0, 1.2, 40);
    link(p + "shoulder_1", 0.5, "0 0 0");
    joint(p + "shoulder_roll", p + "shoulder_1", p + "shoulder_2", "0 0 0",
          fmt::format("{} 0 0", -0.3 * s), "1 0 0", s > 0 ? -0.3 : -2.5, s > 0 ? 2.5 : 0.3, 40);
    link(p + "shoulder_2", 0.5, "0 0 0");
    joint(p + "shoulder_yaw", p + "shoulder_2", p + "upper_arm", "0 0 -0.05", "0 0 0", "0 0 1",
          -1.5, 1.5, 30);
    link(p + "upper_arm", 1.2, "0 0 -0.1");
    // never straight
    joint(p + "elbow", p + "upper_arm", p + "forearm", "0 0 -0.2", "0 0 0", "0 1 0", -2.2, -0.2,
          30);
    link(p + "forearm", 0.8, "0 0 -0.1");
    if (!hands_) return;
    body_ += fmt::format(
        "<joint name=\"{0}wrist\" type=\"continuous\"><parent link=\"{0}forearm\"/>"
        "<child link=\"{0}wrist\"/><origin xyz=\"0 0 -0.2\"/><axis xyz=\"0 0 2\"/></joint>\n"
        "<joint name=\"{0}palm_fixed\" type=\"fixed\"><parent link=\"{0}wrist\"/>"
        "<child link=\"{0}palm\"/><origin xyz=\"0.01 0 -0.06\" rpy=\"0.3 0 0\"/></joint>\n"
        "<link name=\"{0}palm\"/>\n"
        "<joint name=\"{0}finger\" type=\"revolute\"><parent link=\"{0}palm\"/>"
        "<child link=\"{0}finger\"/><origin xyz=\"0 0 -0.03\"/><axis xyz=\"0 1 0\"/>"
        "<limit lower=\"0.1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\n"
        "<joint name=\"{0}finger_tip\" type=\"revolute\"><parent link=\"{0}finger\"/>"
        "<child link=\"{0}finger_tip\"/><origin xyz=\"0 0 -0.03\"/><axis xyz=\"0 1 0\"/>"
        "<limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"
        "<mimic joint=\"{0}finger\"/></joint>\n"
        "<joint name=\"{0}thumb\" type=\"revolute\"><parent link=\"{0}palm\"/>"
        "<child link=\"{0}thumb\"/><origin xyz=\"0.02 0 -0.01\"/><axis xyz=\"0 1 0\"/>"
        "<limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\n",
        p);
    link(p + "wrist", 0.3, "0 0 -0.03");
    link(p + "finger", 0.02, "0 0 -0.01");
    link(p + "finger_tip", 0.01, "0 0 -0.01");
    link(p + "thumb", 0.02, "0 0 -0.01");
  }

  bool hands_;
  std::string body_;
};

}  // namespace shigusa::testing_support
