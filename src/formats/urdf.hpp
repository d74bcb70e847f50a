// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <string>
#include <string_view>

#include "formats/xml.hpp"
#include "robot/robot.hpp"

namespace shigusa {

// Limits of a URDF file; more is refused before memory is taken.
inline constexpr std::size_t kUrdfMaxBytes = info_of(FileFormat::urdf).max_bytes;
inline constexpr std::size_t kUrdfMaxTags = 200'000;
inline constexpr int kUrdfMaxLinks = 1024;
inline constexpr int kUrdfMaxDepth = 64;  // of elements in one another
// Lengths, masses and moments beyond this are refused.
inline constexpr double kUrdfMaxValue = 1e6;

// The part of a URDF file that a motion needs: links with masses and simple shapes,
// joints. Meshes, materials, sensors and what simulators add are left out. As a text (write_xml) it
// gives the same robot as the file.
[[nodiscard]] Result<XmlElement> reduced_urdf(std::string_view text, std::string_view name);

// The robot of what reduced_urdf leaves of a file, whose lines errors name.
[[nodiscard]] Result<Robot> robot_of_urdf(const XmlElement& reduced, std::string_view name);

// Parses the text of a URDF file. `name` stands for the file in errors, which name the line, the
// link or joint, the value seen and what is allowed. Files that urdfdom refuses are refused too.
// Sliding, planar, floating and mimic joints are kept at 0, with a doubt.
[[nodiscard]] Result<Robot> parse_urdf(std::string_view text, std::string_view name);

// The robot as a URDF file that parse_urdf reads as the same robot, its angles to a few 1e-16.
// Doubts are not written.
[[nodiscard]] std::string write_urdf(const Robot& robot);

}  // namespace shigusa
