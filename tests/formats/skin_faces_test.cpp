// SPDX-License-Identifier: MIT
#include "formats/skin_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace shigusa {
namespace {

// A triangle of 1 m and 2 m, each of whose corners is bound to its own node.
std::vector<SkinVertex> corners() { return {{{0, 0, 0}, 3}, {{1, 0, 0}, 4}, {{0, 2, 0}, 5}}; }

TEST(SkinFaces, LargeTrianglesHavePointsOnThem) {
  std::vector<SkinVertex> vertices = corners();
  add_faces(vertices, {{0, 1, 2}});
  EXPECT_EQ(vertices.size(), 17u * 18u / 2u);  // no edge has more than 16 parts
  for (const SkinVertex& vertex : vertices) {
    const Vec3d& p = vertex.position;
    // each goes with its nearest corner
    const double shares[] = {1.0 - p.x - 0.5 * p.y, p.x, 0.5 * p.y};
    EXPECT_GE(shares[vertex.node - 3], *std::max_element(shares, shares + 3) - 1e-12);
  }
}

}  // namespace
}  // namespace shigusa
