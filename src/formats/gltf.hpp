// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/axes.hpp"

namespace shigusa {

// Limits of a glTF, GLB or VRM file; more is refused before memory is taken.
inline constexpr std::size_t kGltfMaxBytes = info_of(FileFormat::glb).max_bytes;
inline constexpr std::size_t kGltfMaxJsonBytes = std::size_t{40} << 20;  // all of a .gltf file
inline constexpr int kGltfMaxNodes = 4096;
// Numbers beyond this are refused, and so are nodes that stand farther from the origin.
inline constexpr double kGltfMaxValue = 1e9;

enum class VrmVersion { none, v0, v1 };

// Where a node stands in its parent at rest: translation · rotation · scale.
struct GltfPlace {
  Vec3d translation{};
  Quatd rotation{};
  Vec3d scale{1, 1, 1};

  // With the scale in its matrix.
  [[nodiscard]] Transformd transform() const {
    return {scaled_columns(to_matrix(rotation), scale), translation};
  }
};

// A node of the file that shows a mesh.
struct GltfMeshNode {
  int mesh = 0;   // index in the file
  int skin = -1;  // index in GltfCharacter::skins; -1: the mesh goes with the node as one piece
  int node = -1;  // of the skeleton, the nearest at or above it; -1: none is
  Transformd
      place;  // at rest: of the mesh in that node, or in the world; with scales in its matrix
};

// The joints that a mesh is bound to.
struct GltfSkin {
  std::vector<int> joints;      // nodes of the skeleton, in the order in which vertices number them
  int inverse_bind_poses = -1;  // index of the file's accessor; -1: each is the identity
};

// The skeleton of a character in glTF 2.0. Metres, +Y up; characters face +Z, those of VRM 0.x -Z.
struct GltfCharacter {
  // one frame, the rest pose: where the nodes' own places put them, whatever pose the mesh was
  // bound in. No node is turned in it: offsets are along the axes of the world.
  SkeletonMotion rest;
  std::vector<int> file_node;     // (nodes) the index that each has in the file
  std::vector<GltfPlace> places;  // (nodes) as the file has them; a matrix in its parts
  VrmVersion vrm = VrmVersion::none;
  HumanoidMap humanoid;  // what a VRM file tells of its bones; empty for others
  // all of VRM's bones by its own names, "leftUpperLeg": nodes of the skeleton
  std::vector<std::pair<std::string, int>> vrm_bones;
  std::vector<GltfMeshNode> meshes;  // in the order of the file's nodes
  std::vector<GltfSkin> skins;
  std::vector<Message> doubts;
};

// Parses the bytes of a .gltf, .glb or .vrm file. Of these only the JSON part is read, so no other
// file is opened. Errors name the node, the value seen and what is allowed; `name` stands for the
// file in them.
//
// - Nodes are the joints of all skins and the bones of VRM, all that these hang on, and the leaves
//   on them that carry no mesh: tips of fingers and toes. A file without joints and bones gives
//   all nodes. Where the joints of skins make no person, whose limbs may be rigid parts, and all
//   nodes but those that only show meshes do, the skeleton is of these, with a doubt.
// - Scales go into the offsets, mirroring ones too. Bones below a scale that is not the same along
//   its axes keep the lengths that they have in the rest pose; the doubts name such nodes.
// - Names are made unique as parse_bvh does; a node without a name is "node 17" by its index.
// - Bones of the VRM map that name no node of the file are left out, with a doubt.
[[nodiscard]] Result<GltfCharacter> parse_gltf(std::string_view bytes, std::string_view name);

}  // namespace shigusa
