// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "formats/gltf.hpp"

namespace shigusa {

// World placements of nodes that stand in their parents at `places` (nodes), scales in their
// matrices.
[[nodiscard]] std::vector<Transformd> placed_nodes(const Skeleton& skeleton,
                                                   std::span<const GltfPlace> places);

// The pose `world` of a skeleton as a frame of its motion: each node's rotation is its turn from
// `resting`. (nodes) both as placed_nodes has them.
[[nodiscard]] std::vector<LocalTransform> turned_from_rest(const Skeleton& skeleton,
                                                           const std::vector<Transformd>& resting,
                                                           const std::vector<Transformd>& world);

// A place without shear in its parts; a mirroring one has a negative scale along x.
[[nodiscard]] GltfPlace parts_of(const Transformd& place);

}  // namespace shigusa
