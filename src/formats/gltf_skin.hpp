// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "body/skin.hpp"
#include "formats/gltf.hpp"

namespace shigusa {

// Largest number of vertices kept; of larger meshes every second, third, … vertex is taken.
inline constexpr std::size_t kSkinMaxVertices = 1'000'000;
// Largest number of indices, and of mesh parts shown by nodes, that are read.
inline constexpr std::size_t kSkinMaxIndices = 50'000'000;
inline constexpr std::size_t kSkinMaxParts = 20'000;
// Largest number of triangles; of larger meshes only vertices are taken.
inline constexpr std::size_t kSkinMaxFaces = 200'000;

// Choice of a skin's data of the faces between its vertices.
enum class SkinFaces { points, triangles };

// Vertices of a file's meshes as viewers show them, with the skeleton's nodes at `places` (nodes;
// character.places for the rest pose, or GltfMotion::posed). Metres, in the file's axes. `bytes`
// must be those that the character was parsed from; `name` stands for the file.
//
// - A skinned vertex is at Σ wᵢ · joint transform · inverse bind matrix · position, with the
//   weights of both sets, which need not add up to 1; its node is the joint of the largest weight,
//   the first of equal ones. Other vertices belong to their mesh's node.
// - Large triangles get further points between their vertices (skin_faces.hpp), as coarse meshes
//   have vertices only at their edges; or the triangles are kept, if there are at most
//   kSkinMaxFaces.
// - Vertices without an index are not shown and left out. Morph targets are at rest.
// - Numbers are floats or integers (KHR_mesh_quantization), sparse or not, from the binary chunk or
//   from embedded data, decoded if packed by Draco or meshopt (in a build with
//   SHIGUSA_PACKED_MESHES). Other files are not opened: parts of a mesh that are left out are
//   counted in the doubts, with the reason of the first.
[[nodiscard]] Skin read_gltf_skin(std::string_view bytes, std::string_view name,
                                  const GltfCharacter& character, std::span<const GltfPlace> places,
                                  SkinFaces faces = SkinFaces::points);

}  // namespace shigusa
