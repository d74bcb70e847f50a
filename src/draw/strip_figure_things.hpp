// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "strip_figure_canvas.hpp"

namespace shigusa::strip {

// A rectangle that things are measured by and cut at.
struct Box {
  double left = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  double top = 0.0;

  void add(Point p, double radius);
};

// A corner of a thing as the viewer sees it.
struct SeenCorner {
  Point at;
  double depth = 0.0;  // towards the viewer
};

using Segment = std::array<Point, 2>;

// The picture of a thing.
struct SeenThing {
  std::vector<Point> face;     // once around it
  std::vector<Segment> edges;  // of a box those that its own faces do not hide, else its outline
  bool near = false;           // nearer to the viewer than the figure
};

// The picture of a thing with these corners, as thick as a ball of `radius` about each, within the
// window. Eight corners without thickness are a box's: a corner's number has a bit for each side
// that it lies on.
[[nodiscard]] SeenThing seen_thing(const std::vector<SeenCorner>& corners, double radius,
                                   const Box& window);

}  // namespace shigusa::strip
