// SPDX-License-Identifier: MIT
#pragma once

#include <cairo.h>

#include <cstdint>
#include <memory>
#include <shigusa/io/strip_figure.hpp>
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

// Bytes of the UTF-8 character that `text` begins with; 0 where it begins with none.
[[nodiscard]] std::size_t code_point_length(std::string_view text);

// Width of a line of UTF-8 text at a font size, points.
[[nodiscard]] double text_width(const std::string& text, double size);

// Lines of at most that width: broken at spaces, or inside words that are longer than a line.
[[nodiscard]] std::vector<std::string> wrap_text(std::string_view text, double size, double width);

// A white page of one of the formats. It keeps to filled and stroked paths: text, clips, groups and
// patterns would put numbered names into SVG that differ from run to run. Text becomes outlines,
// which also look the same where its font is missing.
class Canvas {
 public:
  Canvas(FigureFormat format, double width, double height, double pixels_per_point);

  // The convex hull of discs, filled, with a white rim of the given width around it.
  void hull(std::span<const Disc> discs, Colour fill, double rim = 0.0);
  void ring(Disc disc, Colour colour, double width);
  // A line through the points with round ends; `dash` is the length of dashes and gaps, 0 for none.
  void line(std::span<const Point> points, Colour colour, double width, double dash = 0.0);
  // A disc in black and white quarters, as centres of mass are marked in drawings.
  void quartered(Disc disc, Colour colour);
  // `at` is on the base line.
  void text(Point at, const std::string& text, double size, Colour colour, Align align);

  // The file's bytes; the canvas is of no use afterwards. Fails when the library refused, for lack
  // of memory for instance.
  [[nodiscard]] Result<std::string> finish();

 private:
  struct Destroy {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  void source(Colour colour);

  FigureFormat format_;
  // on the heap because the surface writes to it through a pointer
  std::unique_ptr<std::string> bytes_ = std::make_unique<std::string>();
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace shigusa::strip
