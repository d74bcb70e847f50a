// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/io/gltf.hpp>
#include <span>
#include <vector>

namespace shigusa {

// (nodes) where nodes of these places in their parents stand in the world, scales in their
// matrices.
[[nodiscard]] inline std::vector<Transformd> world_places(const Skeleton& skeleton,
                                                          std::span<const GltfPlace> places) {
  std::vector<Transformd> world;
  world.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const GltfPlace& place = places[i];
    const Mat3d r = to_matrix(place.rotation);
    const Transformd local{{r.cx * place.scale.x, r.cy * place.scale.y, r.cz * place.scale.z},
                           place.translation};
    const int parent = skeleton.nodes[i].parent;
    world.push_back(parent < 0 ? local : world[static_cast<std::size_t>(parent)] * local);
  }
  return world;
}

}  // namespace shigusa
