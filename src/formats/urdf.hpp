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

// Limits of a URDF file, checked before memory is taken.
inline constexpr std::size_t kUrdfMaxBytes = info_of(FileFormat::urdf).max_bytes;
inline constexpr std::size_t kUrdfMaxTags = 200'000;
inline constexpr int kUrdfMaxLinks = 1024;
inline constexpr int kUrdfMaxDepth = 64;  // of elements in one another
// Largest length, mass and moment.
inline constexpr double kUrdfMaxValue = 1e6;

// Reduces a URDF file to the elements relevant to motion: links with masses and simple shapes, and
// joints. Meshes, materials, sensors and simulator extensions are left out. Its text (write_xml)
// gives the same robot as the file.
[[nodiscard]] Result<XmlElement> reduced_urdf(std::string_view text, std::string_view name);

// Robot of a file reduced by reduced_urdf; errors refer to the lines of the original.
[[nodiscard]] Result<Robot> robot_of_urdf(const XmlElement& reduced, std::string_view name);

// Parses the text of a URDF file. `name` stands for the file in errors, which state the line, the
// link or joint, the value seen and the allowed range. Files that urdfdom refuses are refused too.
// Sliding, planar, floating and mimic joints are kept at 0, with a doubt.
[[nodiscard]] Result<Robot> parse_urdf(std::string_view text, std::string_view name);

// The robot as a URDF file that parse_urdf reads as the same robot, with angles accurate to a few
// 1e-16. Doubts are not written.
[[nodiscard]] std::string write_urdf(const Robot& robot);

}  // namespace shigusa
