// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf.hpp"

namespace shigusa {

// Limits of a sampled animation, checked before memory is taken.
inline constexpr int kGltfMaxFrames = 200'000;
inline constexpr std::size_t kGltfMaxTransforms = 8'000'000;  // frames × nodes

struct AnimationChoice {
  std::string animation{};   // its name, or its index from 0; empty: the first
  double frame_rate = 60.0;  // Hz, sampling rate, > 0
  int posed = 0;             // frame whose local transforms are kept
  bool gaps = false;         // damaged tracks and keys are left out; else they are errors
};

// Range of frames in which a node's transform is unknown because of damaged keys.
struct GltfGap {
  int node = 0;  // of the skeleton
  int first = 0;
  int last = 0;
};

// The time of an action (s) that a file of shigusa's tells.
struct GltfActionTime {
  double start = 0.0;
  double end = 0.0;
};

// A character's motion in an animation of its file.
struct GltfMotion {
  GltfCharacter character;  // `humanoid` also by the map of a VRM animation
  std::string animation{};  // its name, or its index if unnamed
  // nodes of character.rest, with rotations relative to the rest pose. Metres.
  SkeletonMotion motion;
  // (nodes) as character.places, in the requested frame; empty if there is no such frame
  std::vector<GltfPlace> posed;
  std::vector<Message> doubts;            // the character's and the animation's
  std::vector<GltfGap> gaps{};            // if requested
  std::vector<GltfActionTime> actions{};  // in their order; empty: none that can be read
};

// A pose of a character's nodes.
struct GltfPose {
  std::vector<LocalTransform> local;  // (nodes of character.rest) turned from the rest pose
  std::vector<GltfPlace> places;      // (nodes) as character.places
};

// Bind pose of the meshes from the inverse bind matrices of the skins; empty if it is the rest
// pose, or if it cannot be read. Joints without a skin keep their local rest transforms. Numbers
// are read as in parse_gltf_animation.
[[nodiscard]] std::optional<GltfPose> gltf_bind_pose(std::string_view bytes, std::string_view name,
                                                     const GltfCharacter& character);

// Names of a file's animations, the index for one without a name. Fails if a GLB's header or chunks
// are malformed; a text that is no glTF has no animations.
[[nodiscard]] Result<std::vector<std::string>> gltf_animation_names(std::string_view bytes,
                                                                    std::string_view name);

// Parses a .glb, .vrm, .gltf or .vrma file with an animation and samples it from time 0. Numbers
// come from the binary chunk or from embedded data; other files are not opened. Errors state the
// place, the value seen and the allowed range; `name` stands for the file in them.
//
// - LINEAR, STEP and CUBICSPLINE; translation, rotation and scale of nodes. Morph weights and
// targets of extensions are left out. Normalised bytes and shorts are decoded.
// - Before its first key and after its last a node keeps their values.
[[nodiscard]] Result<GltfMotion> parse_gltf_animation(std::string_view bytes, std::string_view name,
                                                      const AnimationChoice& choice = {});

// Reads and parses a file.
[[nodiscard]] Result<GltfMotion> read_gltf_animation(const std::filesystem::path& path,
                                                     const AnimationChoice& choice = {});

}  // namespace shigusa
