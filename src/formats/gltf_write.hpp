// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf.hpp"

namespace shigusa {

// How one node of a glTF file moves.
struct GltfTrack {
  int node = 0;                     // index in the file
  GltfPlace rest;                   // where it stands: what a matrix is replaced by
  std::vector<Quatd> rotations;     // (frames), or empty where it does not turn
  std::vector<Vec3d> translations;  // (frames) in its parent, or empty where it does not move
  std::vector<Vec3d> scales{};      // (frames), or empty where it has that of rest
};

struct GltfAnimation {
  std::string name;
  double frame_time = 1.0 / 60.0;  // s
  int frames = 0;
  std::vector<GltfTrack> tracks;  // one for each node
};

// The fate of the animations that a file has.
enum class OwnAnimations { kept, left_out };

// The file with animations added before its own, as GLB; `bytes` are of a .glb, .vrm or .gltf file
// that parse_gltf reads. All else stays as it is, byte for byte: the JSON text but for the entries
// added, the binary chunk, to which the animations' numbers are appended, and further chunks. Of a
// node that moves a matrix becomes translation, rotation and scale, as glTF asks. Rotations go on
// without a jump from q to -q; tracks are interpolated linearly.
//
// A property that the file's own animations have keys of and an added one has not, is held at rest
// by two keys: players leave it as the animation before had it.
//
// Fails where the file is none that parse_gltf reads, and where it refers to other files, which
// would be lost: `name` stands for the file in messages.
[[nodiscard]] Result<std::string> add_animations(std::string_view bytes, std::string_view name,
                                                 std::span<const GltfAnimation> animations,
                                                 OwnAnimations own = OwnAnimations::kept);

// Whether add_animations can take a file that parse_gltf has read: an error tells what it cannot
// keep.
[[nodiscard]] Result<void> check_animations_fit(std::string_view bytes, std::string_view name);

// A VRM animation (VRMC_vrm_animation 1.0), for any VRM character.
struct VrmAnimation {
  // One humanoid bone at rest, all unturned; parents first, the hips at the root.
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
