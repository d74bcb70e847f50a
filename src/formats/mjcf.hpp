// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <string>
#include <string_view>

#include "robot/robot.hpp"

namespace shigusa {

// Limits of an MJCF model, checked before memory is taken.
inline constexpr std::size_t kMjcfMaxBytes =
    info_of(FileFormat::mjcf).max_bytes;             // of each of its files
inline constexpr std::size_t kMjcfMaxTags = 50'000;  // of all of them
inline constexpr int kMjcfMaxFiles = 32;
inline constexpr int kMjcfMaxDepth = 64;     // of bodies and frames in one another
inline constexpr int kMjcfMaxNesting = 100;  // of elements
inline constexpr int kMjcfMaxLinks = 1024;
// Largest length, mass, moment and angle.
inline constexpr double kMjcfMaxValue = 1e6;

// Loader of included files, by their path relative to the model's. A file is searched for beside
// the including one, then beside the main one. On ErrorCode::not_found the model is read without
// it, with a doubt.
using MjcfInclude = std::function<Result<std::string>(const std::string& file)>;

// The error of a model, preceded by the doubt that names absent included files.
[[nodiscard]] Error after_absent(const std::vector<Message>& doubts, Error error);

// Loader of files in a folder and its subfolders; other paths are an error.
[[nodiscard]] MjcfInclude included_from(std::filesystem::path folder);

// Parses the text of an MJCF file, MuJoCo's own format. `name` stands for the file in errors, which
// state the line, the value seen and the allowed range.
//
// - The robot is the body of the world with the most joints; that body's own joints, usually a free
//   one, are left out: a robot's root is free.
// - Each hinge is a joint. Of several hinges of one body each but the last gets a massless link of
//   its own, named after the hinge; a ball is three hinges, NAME_x, NAME_y and NAME_z. A link's
//   frame has the body's axes and is at its last hinge, else at the body's origin.
// - A shape named as a hand, on a forearm without a child body, becomes a link.
// - Efforts are the limits of actuators and actuatorfrcrange; a joint without an actuator, or
//   without a limit, has none.
// - Masses are the file's, or from the density of its shapes. Simple shapes are kept, colliding
//   ones separately from visual ones. Meshes, height fields, sites, tendons, sensors and skins are
//   left out.
// - Defaults are those of MuJoCo 3: angles in degrees, and limits wherever there is a range.
// - Sliding joints, and joints that follow another by an equality, are fixed at 0, with a doubt.
[[nodiscard]] Result<Robot> parse_mjcf(std::string_view text, std::string_view name,
                                       const MjcfInclude& include = {});

}  // namespace shigusa
