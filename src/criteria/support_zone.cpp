// SPDX-License-Identifier: MIT
#include "criteria/support_zone.hpp"

#include <algorithm>

namespace shigusa {
namespace {

// Twice the area of the triangle, positive if counter-clockwise from above.
double turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z);
}

// Adds a corner to a convex chain, and removes those that it makes concave or straight.
void add_corner(const Vec3d& corner, std::size_t kept, std::vector<Vec3d>& chain) {
  while (chain.size() >= kept + 2 && turn(chain[chain.size() - 2], chain.back(), corner) <= 0.0) {
    chain.pop_back();
  }
  chain.push_back(corner);
}

}  // namespace

std::vector<Vec3d> support_polygon(const BodyModel& body, const State& start, LiftedHeels lifted) {
  const Kinematics<double> kinematics = placed(body, start);
  std::vector<Vec3d> points;
  for (std::size_t f = 0; f < body.feet().size(); ++f) {
    const Foot& foot = body.feet()[f];
    const bool up = foot.heel && ((lifted >> f) & 1U) != 0;
    for (const Vec3d& corner : up ? foot.heel->forefoot : foot.outline) {
      points.push_back(kinematics.point(foot.link, corner));
    }
  }
  // Andrew's monotone chain: one side from back to front, the other from front to back
  const auto before = [](const Vec3d& a, const Vec3d& b) {
    return a.z < b.z || (a.z == b.z && a.x < b.x);
  };
  std::sort(points.begin(), points.end(), before);
  std::vector<Vec3d> hull;
  for (const Vec3d& point : points) add_corner(point, 0, hull);
  const std::size_t first_side = hull.empty() ? 0 : hull.size() - 1;
  for (std::size_t i = points.size(); i-- > 1;) add_corner(points[i - 1], first_side, hull);
  // the last corner repeats the first
  if (!hull.empty()) hull.pop_back();
  return hull;
}

std::vector<SupportEdge> support_edges(const BodyModel& body, const State& start,
                                       LiftedHeels lifted) {
  const std::vector<Vec3d> corners = support_polygon(body, start, lifted);
  std::vector<SupportEdge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d& from = corners[i];
    const Vec3d& to = corners[(i + 1) % corners.size()];
    const double length =
        sqrt((to.x - from.x) * (to.x - from.x) + (to.z - from.z) * (to.z - from.z));
    if (!(length > 0.0)) continue;
    // to the left of the edge, seen from above
    const double x = (to.z - from.z) / length;
    const double z = -(to.x - from.x) / length;
    edges.push_back({x, z, -(x * from.x + z * from.z)});
  }
  return edges;
}

}  // namespace shigusa
