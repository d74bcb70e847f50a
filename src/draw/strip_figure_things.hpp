// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "strip_figure_canvas.hpp"

namespace shigusa::strip {

// A rectangle for bounds and clipping.
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
  std::vector<Point> face;     // outline
  std::vector<Segment> edges;  // visible edges of a box, else the outline
  bool near = false;           // nearer to the viewer than the figure
  double depth = 0.0;          // towards the viewer
  bool moves = false;          // painted among the pieces of the figure, by its depth
};

// Picture of a thing given by its corners, dilated by `radius`, within the window. Eight corners
// without thickness are a box's: bits of a corner's number give its side along each axis.
[[nodiscard]] SeenThing seen_thing(const std::vector<SeenCorner>& corners, double radius,
                                   const Box& window);

}  // namespace shigusa::strip
