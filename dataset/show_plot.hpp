// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// Number with separators, 1234567 as "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);

// Axis ticks at a round step: at most `most` of them within low..high.
struct Ticks {
  double step = 1.0;
  std::vector<double> at;
};
[[nodiscard]] Ticks ticks(double low, double high, int most);

// Label of a tick, with the digits of its step.
[[nodiscard]] std::string tick_label(double value, double step);

// Frame of a plot: a range of numbers on each axis, and the drawing area. Lengths in the picture's
// own unit, a pixel of a narrow screen.
struct PlotFrame {
  double left = 44.0;
  double top = 10.0;
  double width = 300.0;
  double height = 220.0;
  double low_x = 0.0;
  double high_x = 1.0;
  double low_y = 0.0;
  double high_y = 1.0;
  bool down = false;  // y grows downwards

  [[nodiscard]] double x(double value) const {
    return left + width * (value - low_x) / (high_x - low_x);
  }
  [[nodiscard]] double y(double value) const {
    const double share = (value - low_y) / (high_y - low_y);
    return top + height * (down ? share : 1.0 - share);
  }
};
// Width of all plots.
inline constexpr double kPlotWidth = 360.0;

// Grid lines, ticks and the names of the axes.
[[nodiscard]] std::string axes(const PlotFrame& frame, std::string_view x_name,
                               std::string_view y_name);

// A picture with a title and a sentence below it, as a part of a page. `says`: text for screen
// readers.
struct Picture {
  std::string title;
  std::string caption;  // HTML
  std::string says;
  double height = 280.0;
  std::string body;  // SVG
};
[[nodiscard]] std::string figure(const Picture& picture);

// Marks of one kind in one path: dots, triangles or crosses.
enum class MarkShape { dot, triangle, cross };
class Marks {
 public:
  explicit Marks(MarkShape shape) : shape_(shape) {}
  void add(double x, double y);
  [[nodiscard]] bool empty() const { return path_.empty(); }
  // The path, with a class of the style sheet.
  [[nodiscard]] std::string svg(std::string_view style) const;

 private:
  MarkShape shape_;
  std::string path_;
};

}  // namespace shigusa
