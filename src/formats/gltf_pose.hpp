// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "formats/gltf.hpp"

namespace shigusa {

// World transforms of nodes from their local transforms `places` (nodes), with scales in their
// matrices.
[[nodiscard]] std::vector<Transformd> placed_nodes(const Skeleton& skeleton,
                                                   std::span<const GltfPlace> places);

// The pose `world` of a skeleton as a frame of its motion: rotations are relative to `resting`.
// (nodes) both as placed_nodes returns them.
[[nodiscard]] std::vector<LocalTransform> turned_from_rest(const Skeleton& skeleton,
                                                           const std::vector<Transformd>& resting,
                                                           const std::vector<Transformd>& world);

// Decomposes a transform without shear; a mirroring one has a negative scale along x.
[[nodiscard]] GltfPlace parts_of(const Transformd& place);

}  // namespace shigusa
