// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf.hpp"

namespace shigusa {

// Animation of one node of a glTF file.
struct GltfTrack {
  int node = 0;                     // index in the file
  GltfPlace rest;                   // rest transform, which replaces a matrix
  std::vector<Quatd> rotations;     // (frames), or empty if it does not turn
  std::vector<Vec3d> translations;  // (frames) in its parent, or empty if it does not move
  std::vector<Vec3d> scales{};      // (frames), or empty if it keeps its rest scale
};

// Triangles of one colour.
struct GltfMesh {
  std::vector<Vec3d> positions;
  std::vector<Vec3d> normals;          // (positions) unit vectors
  std::vector<std::uint16_t> corners;  // (triangles × 3) indices, counter-clockwise from outside
};

// A thing beside the character, which the file does not have yet.
struct GltfThing {
  std::string name;
  GltfMesh mesh;
  std::vector<Quatd> rotations;     // (frames)
  std::vector<Vec3d> translations;  // (frames) in the world of the file
};

// A named part of an animation.
struct GltfMarker {
  std::string_view name;
  double start = 0.0;  // s
  double end = 0.0;    // s
};

struct GltfAnimation {
  std::string name;
  double frame_time = 1.0 / 60.0;  // s
  int frames = 0;
  std::vector<GltfTrack> tracks;      // one for each node
  std::vector<GltfThing> things{};    // the same ones in all animations that are added together
  std::vector<GltfMarker> markers{};  // "shigusa_actions" of its extras
};

// Treatment of the animations that a file already has.
enum class OwnAnimations { kept, left_out };

// The file with animations added before its own, as GLB; `bytes` are of a .glb, .vrm or .gltf file
// readable by parse_gltf. Everything else is kept byte for byte: the JSON text except for the added
// entries, the binary chunk, to which the animations' data is appended, and further chunks. The
// matrix of a moving node becomes translation, rotation and scale, as glTF requires. Rotations are
// continuous, without a change from q to -q; tracks are interpolated linearly.
//
// A property that is animated by the file's own animations but not by an added one is held at rest
// by two keys, as players would otherwise leave it at the previous animation's value.
//
// Things become root nodes of the file's scene after its own nodes, once for all animations, with
// names that no other node has.
//
// Fails if parse_gltf cannot read the file, and if it refers to other files, which would be lost:
// `name` stands for the file in messages.
[[nodiscard]] Result<std::string> add_animations(std::string_view bytes, std::string_view name,
                                                 std::span<const GltfAnimation> animations,
                                                 OwnAnimations own = OwnAnimations::kept);

// Whether add_animations can process a file that parse_gltf has read; the error states what would
// be lost.
[[nodiscard]] Result<void> check_animations_fit(std::string_view bytes, std::string_view name);

// A VRM animation (VRMC_vrm_animation 1.0), applicable to any VRM character.
struct VrmAnimation {
  // A humanoid bone at rest without rotation; parents first, the hips as the root.
  struct Bone {
    std::string name;  // VRM 1.0's: "leftUpperLeg"
    int parent = -1;
    Vec3d offset{};  // m, in the parent
  };
  std::vector<Bone> bones;
  GltfAnimation animation;  // of the bones, by index
};
[[nodiscard]] Result<std::string> format_vrm_animation(const VrmAnimation& motion);

}  // namespace shigusa
