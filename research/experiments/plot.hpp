// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// Pictures of docs/experiments.md, as SVG.
namespace shigusa::bench {

// A named series of points; y has as many values as x.
struct PlotSeries {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

struct PlotAxis {
  std::string label;
  std::vector<double> ticks;  // the first and the last are the axis' ends; two or more, all above 0
};

// A named straight line y = factor · x.
struct PlotGuide {
  std::string name;
  double factor = 1.0;
};

// Both axes are logarithmic. Lines join a series' points, with names at their ends; values beyond
// an axis are drawn at its end.
[[nodiscard]] std::string line_plot(const PlotAxis& x, const PlotAxis& y,
                                    const std::vector<PlotSeries>& lines);
// Scatter plot; names are in a corner, those of guides at their upper ends.
[[nodiscard]] std::string dot_plot(const PlotAxis& x, const PlotAxis& y,
                                   const std::vector<PlotSeries>& dots,
                                   const std::vector<PlotGuide>& guides);

}  // namespace shigusa::bench
