// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/voxels.hpp"

namespace shigusa {

// Cells along the longest side of a mesh: the finest grid, and coarser ones that are tried where
// that takes too many boxes.
inline constexpr int kSceneCells[] = {48, 36, 27, 20, 15, 11, 8, 6, 4, 3, 2};

// Boxes that cover a mesh, along its surface's axes.
struct MeshBoxes {
  std::vector<Bounds> boxes{};
  std::size_t grid = 0;  // the next of kSceneCells, which has fewer
};

// At most `most` boxes that cover a mesh: of the finest grid from kSceneCells[grid] on that needs
// no more, else its bounds. They end at its surface, or where the next one begins. `hollow`: points
// that are outside. None if the surface has no points.
[[nodiscard]] MeshBoxes boxes_of(const Surface& surface, std::size_t most,
                                 std::span<const Vec3d> hollow, std::size_t grid = 0);

}  // namespace shigusa
