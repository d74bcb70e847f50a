// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

// Small humanoids as MJCF, in common layouts. All face x, z up.
namespace shigusa::testing_support {

// Several hinges per body, capsules between two points, degrees, nested classes and motors by gear,
// as in research models. Without hands the arms end at the forearms; without ankles the feet are
// fixed to the shanks.
inline std::string research_mjcf(bool hands = true, bool ankles = true) {
  std::string legs;
  std::string arms;
  std::string motors;
  for (const char* side : {"right", "left"}) {
    const double s = side[0] == 'l' ? 1.0 : -1.0;
    const std::string ankle = fmt::format(
        "<joint name=\"{0}_ankle_y\" class=\"ankle\" axis=\"0 1 0\" pos=\"0 0 0.08\"/>"
        "<joint name=\"{0}_ankle_x\" class=\"ankle\" axis=\"1 0 0.4\" pos=\"0 0 0.05\"/>",
        side);
    legs += fmt::format(
        "<body name=\"{0}_thigh\" pos=\"0 {1} -0.04\">\n"
        "<joint name=\"{0}_hip_x\" axis=\"{2} 0 0\" range=\"-30 20\"/>\n"
        "<joint name=\"{0}_hip_z\" axis=\"0 0 {2}\" range=\"-60 40\"/>\n"
        "<joint name=\"{0}_hip_y\" class=\"hip_y\"/>\n"
        "<geom name=\"{0}_thigh\" fromto=\"0 0 0 0 {3} -0.34\" size=\"0.06\"/>\n"
        "<body name=\"{0}_shin\" pos=\"0 {3} -0.41\">\n"
        "<joint name=\"{0}_knee\" axis=\"0 -1 0\" range=\"-150 2\" pos=\"0 0 0.02\"/>\n"
        "<geom name=\"{0}_shin\" fromto=\"0 0 0 0 0 -0.3\" size=\"0.049\"/>\n"
        "<body name=\"{0}_foot\" pos=\"0 0 -0.4\">{4}\n"
        "<geom name=\"{0}_foot1\" class=\"foot\" fromto=\"-0.07 -0.02 0 0.14 -0.04 0\"/>\n"
        "<geom name=\"{0}_foot2\" class=\"foot\" fromto=\"-0.07 0.02 0 0.14 0.04 0\"/>\n"
        "</body></body></body>\n",
        side, 0.1 * s, s, -0.01 * s, ankles ? ankle : "");
    const std::string hand = fmt::format(
        "<body name=\"{0}_hand\" pos=\"0.18 {1} 0.18\">"
        "<geom name=\"{0}_hand\" type=\"sphere\" size=\"0.04\" zaxis=\"1 {1} 1\"/></body>",
        side, -0.18 * s);
    arms += fmt::format(
        "<body name=\"{0}_upper_arm\" pos=\"0 {1} 0.06\">\n"
        "<joint name=\"{0}_shoulder1\" axis=\"{8} 1 {2}\" range=\"-85 60\"/>\n"
        "<joint name=\"{0}_shoulder2\" axis=\"0 -1 {2}\" range=\"-85 60\"/>\n"
        "<geom name=\"{0}_upper_arm\" fromto=\"0 0 0 0.16 {3} -0.16\" size=\"0.04\"/>\n"
        "<body name=\"{0}_lower_arm\" pos=\"0.18 {4} -0.18\">\n"
        "<joint name=\"{0}_elbow\" axis=\"0 -1 {2}\" range=\"-90 50\"/>\n"
        "<geom name=\"{0}_lower_arm\" fromto=\"0.01 {5} 0.01 0.17 {6} 0.17\" size=\"0.03\"/>\n"
        "{7}</body></body>\n",
        side, 0.17 * s, -s, 0.16 * s, 0.18 * s, -0.01 * s, -0.17 * s,
        hands ? hand
              : fmt::format("<geom name=\"{0}_hand\" type=\"sphere\" size=\"0.04\" "
                            "pos=\"0.18 {1} 0.18\"/>",
                            side, -0.18 * s),
        -2.0 * s);
    for (const auto& [joint, gear] :
         {std::pair("hip_x", 40), std::pair("hip_z", 40), std::pair("hip_y", 120),
          std::pair("knee", 80), std::pair("shoulder1", 20), std::pair("shoulder2", 20),
          std::pair("elbow", 40)}) {
      motors += fmt::format("<motor joint=\"{}_{}\" gear=\"{}\"/>\n", side, joint, gear);
    }
    if (!ankles) continue;
    for (const char* axis : {"x", "y"}) {
      motors += fmt::format("<motor joint=\"{}_ankle_{}\" gear=\"20\"/>\n", side, axis);
    }
  }
  return "<mujoco model=\"research\">\n<compiler angle=\"degree\"/>\n"
         "<default><motor ctrlrange=\"-1 1\" ctrllimited=\"true\"/>\n"
         "<default class=\"body\"><geom type=\"capsule\"/>"
         "<joint type=\"hinge\" limited=\"true\" damping=\"0.2\"/>\n"
         "<default class=\"foot\"><geom size=\"0.027\"/></default>\n"
         "<default class=\"big\"><joint stiffness=\"10\"/>"
         "<default class=\"hip_y\"><joint axis=\"0 1 0\" range=\"-120 20\"/></default></default>\n"
         "<default class=\"ankle\"><joint range=\"-50 50\"/></default></default></default>\n"
         "<worldbody><light pos=\"0 0 3\"/><geom name=\"floor\" type=\"plane\" size=\"0 0 1\"/>\n"
         "<body name=\"torso\" pos=\"0 0 1.4\" childclass=\"body\"><freejoint/>\n"
         "<geom name=\"chest\" fromto=\"0 -0.07 0 0 0.07 0\" size=\"0.07\"/>\n"
         "<body name=\"head\" pos=\"0 0 0.19\"><geom type=\"sphere\" size=\"0.09\"/></body>\n"
         "<body name=\"lower_waist\" pos=\"-0.01 0 -0.26\" quat=\"1 0 -0.002 0\">\n"
         "<joint name=\"abdomen_z\" axis=\"0 0 1\" range=\"-45 45\" pos=\"0 0 0.065\"/>\n"
         "<joint name=\"abdomen_y\" axis=\"0 1 0\" range=\"-75 30\" pos=\"0 0 0.065\"/>\n"
         "<geom fromto=\"0 -0.06 0 0 0.06 0\" size=\"0.06\"/>\n"
         "<body name=\"pelvis\" pos=\"0 0 -0.165\">\n"
         "<joint name=\"abdomen_x\" axis=\"1 0 0\" range=\"-35 35\" pos=\"0 0 0.1\"/>\n"
         "<geom name=\"butt\" fromto=\"-0.02 -0.07 0 -0.02 0.07 0\" size=\"0.09\"/>\n" +
         legs + "</body></body>\n" + arms + "</body></worldbody>\n<actuator>\n" + motors +
         "<motor joint=\"abdomen_x\" gear=\"40\"/><motor joint=\"abdomen_y\" gear=\"40\"/>"
         "<motor joint=\"abdomen_z\" gear=\"40\"/></actuator>\n</mujoco>\n";
}

// One hinge per body, meshes, given inertias, spheres under the feet, radians, and efforts by
// actuatorfrcrange, as in files of robots' makers.
inline std::string makers_mjcf() {
  std::string text =
      "<mujoco model=\"maker\">\n<compiler angle=\"radian\" meshdir=\"assets\" "
      "autolimits=\"true\"/>"
      "\n<default><default class=\"m\"><joint damping=\"1\" armature=\"0.1\"/>\n"
      "<default class=\"visual\"><geom type=\"mesh\" contype=\"0\" conaffinity=\"0\" group=\"2\" "
      "density=\"0\"/></default>\n"
      "<default class=\"collision\"><geom group=\"3\" type=\"mesh\"/>"
      "<default class=\"sole\"><geom type=\"sphere\" size=\"0.005\"/></default></default>\n"
      "</default></default>\n<worldbody>\n";
  std::string close;
  const auto body = [&](const std::string& name, const std::string& pos, double mass,
                        const std::string& joint) {
    text += fmt::format(
        "<body name=\"{0}_link\" pos=\"{1}\"{2}>\n<inertial pos=\"0.01 0 -0.02\" "
        "quat=\"0.9 0.1 0.2 0.1\" mass=\"{3}\" diaginertia=\"{4} {5} {6}\"/>{7}\n"
        "<geom class=\"visual\" mesh=\"{0}\"/>\n",
        name, pos, joint.empty() ? " childclass=\"m\"" : "", mass, 0.01 * mass, 0.009 * mass,
        0.004 * mass, joint);
  };
  const auto hinge = [](const std::string& name, const char* axis, double lower, double upper,
                        double effort) {
    return fmt::format(
        "<joint name=\"{}_joint\" axis=\"{}\" range=\"{} {}\" actuatorfrcrange=\"-{} {}\"/>", name,
        axis, lower, upper, effort, effort);
  };
  body("pelvis", "0 0 0.79", 4.0, "");
  text += "<freejoint name=\"floating_base\"/>\n";
  for (const char* side : {"left", "right"}) {
    const double s = side[0] == 'l' ? 1.0 : -1.0;
    const std::string p = side + std::string("_");
    body(p + "hip_pitch", fmt::format("0 {} -0.1", 0.064 * s), 1.4,
         hinge(p + "hip_pitch", "0 1 0", -2.5, 2.9, 88));
    body(p + "hip_roll", fmt::format("0 {} -0.03", 0.052 * s), 1.5,
         hinge(p + "hip_roll", "1 0 0", s > 0 ? -0.5 : -2.9, s > 0 ? 2.9 : 0.5, 139));
    body(p + "hip_yaw", "0.025 0 -0.12", 1.7, hinge(p + "hip_yaw", "0 0 1", -2.7, 2.7, 88));
    body(p + "knee", "-0.078 0.002 -0.177", 1.9, hinge(p + "knee", "0 1 0", -0.08, 2.8, 139));
    body(p + "ankle_pitch", "0 0 -0.3", 0.1, hinge(p + "ankle_pitch", "0 1 0", -0.87, 0.52, 50));
    body(p + "ankle_roll", "0 0 -0.017", 0.6, hinge(p + "ankle_roll", "1 0 0", -0.26, 0.26, 50));
    for (const char* at : {"-0.05 0.025", "-0.05 -0.025", "0.12 0.03", "0.12 -0.03"}) {
      text += fmt::format("<geom class=\"sole\" pos=\"{} -0.03\"/>\n", at);
    }
    for (int k = 0; k < 6; ++k) text += "</body>";
  }
  body("waist_yaw", "0 0 0", 0.2, hinge("waist_yaw", "0 0 1", -2.6, 2.6, 88));
  body("torso", "0 0 0.044", 7.8, hinge("waist_pitch", "0 1 0", -0.52, 0.52, 50));
  text += "<site name=\"imu\" pos=\"0 0 0.1\"/>\n";
  for (const char* side : {"left", "right"}) {
    const double s = side[0] == 'l' ? 1.0 : -1.0;
    const std::string p = side + std::string("_");
    body(p + "shoulder_pitch", fmt::format("0 {} 0.24", 0.1 * s), 0.7,
         hinge(p + "shoulder_pitch", s > 0 ? "0 1 0.27" : "0 1 -0.27", -3.0, 2.6, 25));
    body(p + "shoulder_roll", fmt::format("0 {} -0.013", 0.038 * s), 0.6,
         hinge(p + "shoulder_roll", "1 0 0", s > 0 ? -1.5 : -2.2, s > 0 ? 2.2 : 1.5, 25));
    body(p + "shoulder_yaw", fmt::format("0 {} -0.1", 0.006 * s), 0.7,
         hinge(p + "shoulder_yaw", "0 0 1", -2.6, 2.6, 25));
    body(p + "elbow", "0.015 0 -0.08", 0.6, hinge(p + "elbow", "0 1 0", -1.0, 2.0, 25));
    body(p + "wrist_roll", fmt::format("0.1 {} -0.01", 0.002 * s), 0.1,
         hinge(p + "wrist_roll", "1 0 0", -1.9, 1.9, 25));
    body(p + "rubber_hand", "0.09 0 0", 0.3, "<site name=\"" + p + "palm\"/>");
    for (int k = 0; k < 6; ++k) text += "</body>";
  }
  return text + "</body></body></body></worldbody>\n</mujoco>\n";
}

}  // namespace shigusa::testing_support
