// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// Limits of an FBX file; more is refused before memory is taken.
inline constexpr std::size_t kFbxMaxBytes = info_of(FileFormat::fbx).max_bytes;
inline constexpr int kFbxMaxNodes = 4096;  // models
inline constexpr int kFbxMaxDepth = 64;    // of records in one another
// Records of nodes, their places and connections; others are passed over.
inline constexpr std::size_t kFbxMaxRecords = 300'000;
// Numbers beyond this are refused.
inline constexpr double kFbxMaxValue = 1e9;

// The skeleton of an FBX file of version 6 or 7, text or binary, as a GLB file that parse_gltf
// reads: in metres, +Y up, one node for each of the file's models, with their names and the places
// that their own properties give them. Limb nodes are the joints of a skin; in a file without any,
// all models but meshes, cameras and lights. Meshes, skins, bind poses, constraints and animations
// are left out.
//
// Errors name the line or the byte, or the model, with the value seen and what is allowed; `name`
// stands for the file in them.
[[nodiscard]] Result<std::string> glb_of_fbx(std::string_view bytes, std::string_view name);

}  // namespace shigusa
