// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/axes.hpp"

namespace shigusa {

// Limits of a glTF, GLB or VRM file, checked before memory is taken.
inline constexpr std::size_t kGltfMaxBytes = info_of(FileFormat::glb).max_bytes;
inline constexpr std::size_t kGltfMaxJsonBytes = std::size_t{40} << 20;  // all of a .gltf file
inline constexpr int kGltfMaxNodes = 4096;
// Largest absolute value of a number, and of a node's distance from the origin.
inline constexpr double kGltfMaxValue = 1e9;

enum class VrmVersion { none, v0, v1 };

// Local rest transform of a node: translation · rotation · scale.
struct GltfPlace {
  Vec3d translation{};
  Quatd rotation{};
  Vec3d scale{1, 1, 1};

  // Transform with the scale in its matrix.
  [[nodiscard]] Transformd transform() const {
    return {scaled_columns(to_matrix(rotation), scale), translation};
  }
};

// Extras of a node that describe a thing.
struct GltfExtras {
  std::optional<double> mass;  // kg, as given
  bool upright = false;
};

// A node that shows a mesh.
struct GltfMeshNode {
  int mesh = 0;   // index in the file
  int skin = -1;  // index in GltfCharacter::skins; -1: rigidly attached to the node
  int node = -1;  // of the skeleton, the nearest at or above it; -1: none is
  Transformd
      place;  // at rest: of the mesh in that node, or in the world; with scales in its matrix
};

// Joints to which a mesh is bound.
struct GltfSkin {
  std::vector<int> joints;      // nodes of the skeleton, in the order in which vertices number them
  int inverse_bind_poses = -1;  // index of the file's accessor; -1: each is the identity
};

// Skeleton of a character in glTF 2.0. Metres, +Y up; characters face +Z, those of VRM 0.x -Z.
struct GltfCharacter {
  // one frame, the rest pose: the nodes' own transforms, whatever the mesh's bind pose. Its
  // rotations are the identity: offsets are along the axes of the world.
  SkeletonMotion rest;
  std::vector<int> file_node;      // (nodes) the index that each has in the file
  std::vector<GltfPlace> places;   // (nodes) as the file has them; a matrix in its parts
  std::vector<GltfExtras> extras;  // (nodes)
  VrmVersion vrm = VrmVersion::none;
  HumanoidMap humanoid;  // bones stated by a VRM file; empty for others
  // all VRM bones by their VRM names, such as "leftUpperLeg": nodes of the skeleton
  std::vector<std::pair<std::string, int>> vrm_bones;
  std::vector<GltfMeshNode> meshes;  // in the order of the file's nodes
  std::vector<GltfSkin> skins;
  std::vector<Message> doubts;
};

// Parses the bytes of a .gltf, .glb or .vrm file. Only the JSON part is read, so no other file is
// opened. Errors name the node, the value seen and the allowed range; `name` stands for the file in
// them.
//
// - Nodes are the joints of all skins and the bones of VRM, all their ancestors, and their leaf
//   children without a mesh: tips of fingers and toes. A file without joints and bones gives all
//   nodes. If the joints of skins make no person, but all nodes except those that only show meshes
//   do, the skeleton consists of the latter, with a doubt, since limbs may be rigid parts.
// - Scales are applied to the offsets, mirroring ones too. Bones below a non-uniform scale keep
//   their lengths of the rest pose; doubts name such nodes.
// - Names are made unique as in parse_bvh; a node without a name is "node 17" by its index.
// - Bones of the VRM map without a node in the file are left out, with a doubt.
[[nodiscard]] Result<GltfCharacter> parse_gltf(std::string_view bytes, std::string_view name);

}  // namespace shigusa
