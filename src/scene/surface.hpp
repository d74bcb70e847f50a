// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <shigusa/math.hpp>
#include <vector>

namespace shigusa {

// A box along the axes of a surface (m).
struct Bounds {
  Vec3d low{1e300, 1e300, 1e300};
  Vec3d high{-1e300, -1e300, -1e300};

  void add(const Vec3d& point) {
    for (int k = 0; k < 3; ++k) {
      low[k] = min(low[k], point[k]);
      high[k] = max(high[k], point[k]);
    }
  }
  [[nodiscard]] Vec3d size() const { return high - low; }
  [[nodiscard]] Vec3d middle() const { return (low + high) * 0.5; }
  [[nodiscard]] double longest() const { return max(size().x, max(size().y, size().z)); }
};

// The surface of a mesh.
struct Surface {
  std::vector<Vec3d> points{};  // m
  std::vector<std::array<std::size_t, 3>> triangles{};

  [[nodiscard]] Bounds bounds() const {
    Bounds all;
    for (const Vec3d& point : points) all.add(point);
    return all;
  }
};

// Parts of a triangle's edges that are no longer than `spacing` (m).
[[nodiscard]] inline int parts_of_triangle(const Surface& surface,
                                           const std::array<std::size_t, 3>& corners,
                                           double spacing) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = max(longest, norm(surface.points[corners[k]] - surface.points[corners[(k + 1) % 3]]));
  }
  return 1 + static_cast<int>(min(longest / spacing, 1e4));
}

// Number of points that each_point visits.
[[nodiscard]] inline double count_points(const Surface& surface, double spacing) {
  auto count = static_cast<double>(surface.points.size());
  for (const auto& corners : surface.triangles) {
    const double parts = parts_of_triangle(surface, corners, spacing);
    count += 0.5 * (parts + 1.0) * (parts + 2.0);
  }
  return count;
}

// Visits the vertices of a surface, and points on its triangles that are no farther apart than
// `spacing` (m).
template <class Visit>
void each_point(const Surface& surface, double spacing, Visit&& visit) {
  for (const Vec3d& point : surface.points) visit(point);
  for (const auto& corners : surface.triangles) {
    const int parts = parts_of_triangle(surface, corners, spacing);
    const Vec3d& from = surface.points[corners[0]];
    const Vec3d along = (surface.points[corners[1]] - from) * (1.0 / parts);
    const Vec3d across = (surface.points[corners[2]] - from) * (1.0 / parts);
    for (int a = 0; a <= parts; ++a) {
      for (int b = 0; a + b <= parts; ++b) visit(from + along * a + across * b);
    }
  }
}

}  // namespace shigusa
