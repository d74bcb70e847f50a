// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <shigusa/strip_figure.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa::strip {

// Points (1/72 inch), x to the right, y down.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Disc {
  Point centre;
  double radius = 0.0;
};

struct Colour {
  std::uint32_t rgb = 0;  // 0xRRGGBB
};

enum class Align { left, centre, right };

// Width of a line of UTF-8 text in DejaVu Sans at a font size, points: by a table, so that each
// format and each build has the same layout.
[[nodiscard]] double text_width(std::string_view text, double size);

// Whether the table has all its letters: those of ASCII. Others count as wide ones.
[[nodiscard]] bool has_known_width(std::string_view text);

// Lines of at most that width: broken at spaces, or inside words that are longer than a line.
[[nodiscard]] std::vector<std::string> wrap_text(std::string_view text, double size, double width);

// Part of a disc's rim, from one angle to a larger one; radians, from the x axis towards y.
struct Arc {
  Disc disc;
  double from = 0.0;
  double to = 0.0;
};

// Once around the convex hull of discs, at least one: arcs that common tangents join, or a whole
// turn about the disc that holds all others.
[[nodiscard]] std::vector<Arc> hull_outline(std::span<const Disc> discs);

// A white page of one of the formats.
class Canvas {
 public:
  virtual ~Canvas() = default;

  // The convex hull of discs, filled, with a white rim of the given width around it.
  virtual void hull(std::span<const Disc> discs, Colour fill, double rim = 0.0) = 0;
  virtual void ring(Disc disc, Colour colour, double width) = 0;
  // A line through the points with round ends; `dash` is the length of dashes and gaps, 0 for none.
  virtual void line(std::span<const Point> points, Colour colour, double width,
                    double dash = 0.0) = 0;
  // A disc in black and white quarters, as centres of mass are marked in drawings.
  virtual void quartered(Disc disc, Colour colour) = 0;
  // `at` is on the base line.
  virtual void text(Point at, const std::string& text, double size, Colour colour, Align align) = 0;

  // The file's bytes; the canvas is of no use afterwards. Fails when a library refused, for lack
  // of memory for instance.
  [[nodiscard]] virtual Result<std::string> finish() = 0;
};

// Width and height in points: SvgCanvas, or CairoCanvas for PNG and PDF. Fails with
// ErrorCode::unsupported on those where this build has no cairo.
[[nodiscard]] Result<std::unique_ptr<Canvas>> make_canvas(FigureFormat format, double width,
                                                          double height, double pixels_per_point);

}  // namespace shigusa::strip
