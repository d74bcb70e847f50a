// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "draw/strip_figure_canvas.hpp"

namespace shigusa::bench {

// An axis from its first tick to its last.
struct GraphAxis {
  std::string label;
  std::vector<double> ticks;
};

struct GraphPoint {
  double x = 0.0;
  double y = 0.0;
};

// Lines in a frame with two axes, drawn onto a part of a canvas.
class Graph {
 public:
  struct Place {
    strip::Point corner;  // upper left, of the frame
    double width;
    double height;
  };
  // The canvas outlives the graph.
  Graph(strip::Canvas& canvas, const Place& place, GraphAxis x, GraphAxis y);

  // Shades the range between two heights; call before the lines.
  void band(double low, double high, strip::Colour colour);
  void line(const std::vector<GraphPoint>& points, strip::Colour colour, double width,
            double dash = 0.0);
  void dot(GraphPoint at, strip::Colour colour);
  void words(GraphPoint at, const std::string& text, strip::Colour colour,
             strip::Align align = strip::Align::left);

 private:
  [[nodiscard]] strip::Point at(GraphPoint point) const;

  strip::Canvas* canvas_;
  Place place_;
  GraphAxis x_, y_;
};

}  // namespace shigusa::bench
