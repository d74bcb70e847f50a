// SPDX-License-Identifier: MIT
#include "graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/check.hpp"

namespace shigusa::bench {
namespace {

constexpr strip::Colour kInk{0x222222};
constexpr strip::Colour kGrid{0xe4e4e4};
constexpr double kText = 7.5;  // points

double share(const GraphAxis& axis, double value) {
  const double low = axis.ticks.front();
  return std::clamp((value - low) / (axis.ticks.back() - low), 0.0, 1.0);
}

}  // namespace

Graph::Graph(strip::Canvas& canvas, const Place& place, GraphAxis x, GraphAxis y)
    : canvas_(&canvas), place_(place), x_(std::move(x)), y_(std::move(y)) {
  SHG_CHECK(x_.ticks.size() >= 2 && y_.ticks.size() >= 2, "an axis has two ticks or more");
  const auto grid = [&](GraphPoint a, GraphPoint b) {
    const std::array<strip::Point, 2> ends{at(a), at(b)};
    canvas_->line(ends, kGrid, 0.6);
  };
  for (const double tick : x_.ticks) {
    grid({tick, y_.ticks.front()}, {tick, y_.ticks.back()});
    const strip::Point below = at({tick, y_.ticks.front()});
    canvas_->text({below.x, below.y + 1.3 * kText}, fmt::format("{:g}", tick), kText, kInk,
                  strip::Align::centre);
  }
  for (const double tick : y_.ticks) {
    grid({x_.ticks.front(), tick}, {x_.ticks.back(), tick});
    const strip::Point beside = at({x_.ticks.front(), tick});
    canvas_->text({beside.x - 4.0, beside.y + 0.35 * kText}, fmt::format("{:g}", tick), kText, kInk,
                  strip::Align::right);
  }
  canvas_->text(
      {place_.corner.x + 0.5 * place_.width, place_.corner.y + place_.height + 2.8 * kText},
      x_.label, kText, kInk, strip::Align::centre);
  canvas_->text({place_.corner.x - 14.0, place_.corner.y - kText}, y_.label, kText, kInk,
                strip::Align::left);
}

strip::Point Graph::at(GraphPoint point) const {
  return {place_.corner.x + place_.width * share(x_, point.x),
          place_.corner.y + place_.height * (1.0 - share(y_, point.y))};
}

void Graph::band(double low, double high, strip::Colour colour) {
  constexpr double kSharp = 0.01;
  std::vector<strip::Disc> corners;
  for (const double x : {x_.ticks.front(), x_.ticks.back()}) {
    for (const double y : {low, high}) corners.push_back({at({x, y}), kSharp});
  }
  canvas_->hull(corners, colour);
}

void Graph::line(const std::vector<GraphPoint>& points, strip::Colour colour, double width,
                 double dash) {
  std::vector<strip::Point> drawn;
  for (const GraphPoint& point : points) drawn.push_back(at(point));
  canvas_->line(drawn, colour, width, dash);
}

void Graph::dot(GraphPoint where, strip::Colour colour) {
  const strip::Disc disc{at(where), 2.0};
  canvas_->hull({&disc, 1}, colour);
}

void Graph::words(GraphPoint where, const std::string& text, strip::Colour colour,
                  strip::Align align) {
  canvas_->text(at(where), text, kText, colour, align);
}

}  // namespace shigusa::bench
