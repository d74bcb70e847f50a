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

// Limits of a sampled animation; more is refused before memory is taken.
inline constexpr int kGltfMaxFrames = 200'000;
inline constexpr std::size_t kGltfMaxTransforms = 8'000'000;  // frames × nodes

struct AnimationChoice {
  std::string animation{};   // its name, or its index from 0; empty: the first
  double frame_rate = 60.0;  // Hz, what it is sampled at, > 0
  int posed = 0;             // the frame whose places are kept
  bool gaps = false;         // damaged tracks and keys are left out; else they are errors
};

// Frames between which a node's place is not known, as the file's keys there are damaged.
struct GltfGap {
  int node = 0;  // of the skeleton
  int first = 0;
  int last = 0;
};

// A character as an animation of its file moves it.
struct GltfMotion {
  GltfCharacter character;  // `humanoid` also by the map of a VRM animation
  std::string animation{};  // its name; where it has none its index
  // nodes of character.rest: a node's rotation is its turn from the rest pose. Metres.
  SkeletonMotion motion;
  // (nodes) as character.places, in the frame asked for; empty where there is no such frame
  std::vector<GltfPlace> posed;
  std::vector<Message> doubts;  // the character's and the animation's
  std::vector<GltfGap> gaps{};  // where they are asked for
};

// A pose of a character's nodes.
struct GltfPose {
  std::vector<LocalTransform> local;  // (nodes of character.rest) turned from the rest pose
  std::vector<GltfPlace> places;      // (nodes) as character.places
};

// The pose in which the meshes were bound to the joints, by the inverse bind matrices of the skins;
// nothing where that is the rest pose, or the file tells none that can be read. Joints of no skin
// stand in their parents as at rest. Numbers are read as parse_gltf_animation reads them.
[[nodiscard]] std::optional<GltfPose> gltf_bind_pose(std::string_view bytes, std::string_view name,
                                                     const GltfCharacter& character);

// The names of a file's animations, of one without a name its index. Fails where a GLB's header or
// chunks are wrong; a text that is no glTF has none.
[[nodiscard]] Result<std::vector<std::string>> gltf_animation_names(std::string_view bytes,
                                                                    std::string_view name);

// Parses a .glb, .vrm, .gltf or .vrma file with an animation and samples it from its time 0 on.
// Numbers come from the binary chunk or from data in the text; other files are not opened. Errors
// name the place, the value seen and what is allowed; `name` stands for the file in them.
//
// - LINEAR, STEP and CUBICSPLINE; translation, rotation and scale of nodes. Weights of meshes, and
//   what extensions animate, are left out. Normalised bytes and shorts are read as such.
// - Before its first key and after its last a node stays as these have it.
[[nodiscard]] Result<GltfMotion> parse_gltf_animation(std::string_view bytes, std::string_view name,
                                                      const AnimationChoice& choice = {});

// Reads and parses a file.
[[nodiscard]] Result<GltfMotion> read_gltf_animation(const std::filesystem::path& path,
                                                     const AnimationChoice& choice = {});

}  // namespace shigusa
