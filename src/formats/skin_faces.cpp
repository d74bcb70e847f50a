// SPDX-License-Identifier: MIT
#include "formats/skin_faces.hpp"

#include <shigusa/math.hpp>

namespace shigusa {
namespace {

constexpr int kMostParts = 16;  // of an edge

double extent_of(const std::vector<SkinVertex>& vertices) {
  Vec3d low = vertices.front().position;
  Vec3d high = low;
  for (const SkinVertex& vertex : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = min(low[axis], vertex.position[axis]);
      high[axis] = max(high[axis], vertex.position[axis]);
    }
  }
  return max(high.x - low.x, max(high.y - low.y, high.z - low.z));
}

}  // namespace

void add_faces(std::vector<SkinVertex>& vertices,
               const std::vector<std::array<std::size_t, 3>>& triangles) {
  if (triangles.empty() || vertices.empty()) return;
  const double spacing = kFaceSpacing * extent_of(vertices);
  if (!(spacing > 0.0)) return;
  const std::size_t most = vertices.size() + kFacePointsMost;
  for (const std::array<std::size_t, 3>& triangle : triangles) {
    const std::array<SkinVertex, 3> corner{vertices[triangle[0]], vertices[triangle[1]],
                                           vertices[triangle[2]]};
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = max(longest, norm(corner[k].position - corner[(k + 1) % 3].position));
    }
    const int parts = static_cast<int>(clamp(longest / spacing, 0.0, double{kMostParts}));
    for (int a = 0; a <= parts && parts > 1; ++a) {
      for (int b = 0; a + b <= parts; ++b) {
        const int shares[] = {a, b, parts - a - b};
        std::size_t nearest = 0;
        Vec3d at{};
        for (std::size_t k = 0; k < 3; ++k) {
          at += corner[k].position * (static_cast<double>(shares[k]) / parts);
          if (shares[k] > shares[nearest]) nearest = k;
        }
        if (shares[nearest] == parts) continue;  // the corner itself
        if (vertices.size() >= most) return;
        vertices.push_back({at, corner[nearest].node, corner[nearest].rigid});
      }
    }
  }
}

}  // namespace shigusa
