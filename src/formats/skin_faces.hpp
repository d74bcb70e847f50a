// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "body/skin.hpp"

namespace shigusa {

// Spacing of points on a figure's faces, as a share of its extent.
inline constexpr double kFaceSpacing = 1.0 / 60.0;
// Largest number of added points.
inline constexpr std::size_t kFacePointsMost = 200'000;

// Adds points on the triangles (vertex indices) with edges longer than kFaceSpacing of the mesh's
// extent, each with the node of its nearest corner.
void add_faces(std::vector<SkinVertex>& vertices,
               const std::vector<std::array<std::size_t, 3>>& triangles);

}  // namespace shigusa
