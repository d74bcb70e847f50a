// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// Limits of an FBX file, checked before memory is taken.
inline constexpr std::size_t kFbxMaxBytes = info_of(FileFormat::fbx).max_bytes;
inline constexpr int kFbxMaxNodes = 4096;  // models
inline constexpr int kFbxMaxDepth = 64;    // of records in one another
// Largest numbers of node, transform and connection records; others are skipped.
inline constexpr std::size_t kFbxMaxRecords = 300'000;
// Largest absolute value of a number.
inline constexpr double kFbxMaxValue = 1e9;

// Converts the skeleton of an FBX file of version 6 or 7, text or binary, to a GLB file for
// parse_gltf: in metres, +Y up, one node per model, with the models' names and local transforms.
// Limb nodes are the joints of a skin; in a file without any, all models except meshes, cameras and
// lights are. Meshes, skins, bind poses, constraints and animations are left out.
//
// Errors state the line or the byte, or the model, with the value seen and the allowed range;
// `name` stands for the file in them.
[[nodiscard]] Result<std::string> glb_of_fbx(std::string_view bytes, std::string_view name);

}  // namespace shigusa
