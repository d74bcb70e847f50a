// SPDX-License-Identifier: MIT
#include "strip_figure_things.hpp"

#include <algorithm>
#include <optional>
#include <shigusa/math.hpp>

namespace shigusa::strip {
namespace {

constexpr int kRound = 24;  // points around a ball

double cross(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Convex hull of points, counter-clockwise from the leftmost one (Andrew's monotone chains).
std::vector<Point> outline_of(std::vector<Point> points) {
  const auto before = [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  const auto same = [](Point a, Point b) { return a.x == b.x && a.y == b.y; };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> around;
  for (const bool below : {true, false}) {
    const std::size_t begin = around.size();
    for (const Point& p : points) {
      while (around.size() > begin + 1 &&
             cross(around[around.size() - 2], around.back(), p) <= 0.0) {
        around.pop_back();
      }
      around.push_back(p);
    }
    around.pop_back();  // first point of the other chain
    if (below) std::reverse(points.begin(), points.end());
  }
  return around;
}

// Signed distance of a point to a side of the window, positive inside.
constexpr int kSides = 4;
double inside(const Box& window, int side, Point p) {
  const double distance[kSides] = {p.x - window.left, window.right - p.x, p.y - window.bottom,
                                   window.top - p.y};
  return distance[side];
}

Point between(Point a, Point b, double share) {
  return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

// Part of a convex outline within the window (Sutherland and Hodgman).
std::vector<Point> cut(std::vector<Point> around, const Box& window) {
  for (int side = 0; side < kSides; ++side) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Point a = around[i];
      const Point b = around[(i + 1) % around.size()];
      const double from = inside(window, side, a);
      const double to = inside(window, side, b);
      if (from >= 0.0) kept.push_back(a);
      if ((from < 0.0) != (to < 0.0)) kept.push_back(between(a, b, from / (from - to)));
    }
    around = std::move(kept);
  }
  return around;
}

// Part of a line within the window.
std::optional<Segment> cut(Segment line, const Box& window) {
  for (int side = 0; side < kSides; ++side) {
    const double from = inside(window, side, line[0]);
    const double to = inside(window, side, line[1]);
    if (from < 0.0 && to < 0.0) return std::nullopt;
    if (from < 0.0) {
      line[0] = between(line[0], line[1], from / (from - to));
    } else if (to < 0.0) {
      line[1] = between(line[0], line[1], from / (from - to));
    }
  }
  return line;
}

// Edges of a box's faces towards the viewer.
std::vector<Segment> box_edges(const std::vector<SeenCorner>& corners) {
  // of the two faces across an axis, the one with the nearer corners
  const auto faces_viewer = [&corners](std::size_t corner, std::size_t axis) {
    const bool nearer = corners[axis].depth > corners[0].depth;
    return nearer == ((corner & axis) != 0);
  };
  std::vector<Segment> edges;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    for (const std::size_t axis : {1U, 2U, 4U}) {
      if ((corner & axis) != 0) continue;
      bool shown = false;
      for (const std::size_t other : {1U, 2U, 4U}) {
        shown = shown || (other != axis && faces_viewer(corner, other));
      }
      if (shown) edges.push_back({corners[corner].at, corners[corner | axis].at});
    }
  }
  return edges;
}

std::vector<Segment> sides_of(const std::vector<Point>& around) {
  std::vector<Segment> sides;
  for (std::size_t i = 0; i < around.size(); ++i) {
    sides.push_back({around[i], around[(i + 1) % around.size()]});
  }
  return sides;
}

}  // namespace

void Box::add(Point p, double radius) {
  left = min(left, p.x - radius);
  right = max(right, p.x + radius);
  bottom = min(bottom, p.y - radius);
  top = max(top, p.y + radius);
}

SeenThing seen_thing(const std::vector<SeenCorner>& corners, double radius, const Box& window) {
  std::vector<Point> points;
  for (const SeenCorner& corner : corners) {
    if (!(radius > 0.0)) points.push_back(corner.at);
    for (int k = 0; radius > 0.0 && k < kRound; ++k) {
      const SinCos<double> turn = sin_cos(kTwoPi * k / kRound);
      points.push_back({corner.at.x + radius * turn.cos, corner.at.y + radius * turn.sin});
    }
  }
  SeenThing seen;
  const std::vector<Point> around = outline_of(std::move(points));
  seen.face = cut(around, window);
  const bool box = corners.size() == 8 && !(radius > 0.0);
  for (const Segment& edge : box ? box_edges(corners) : sides_of(around)) {
    if (const auto shown = cut(edge, window)) seen.edges.push_back(*shown);
  }
  return seen;
}

}  // namespace shigusa::strip
