// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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

// Width of a line of UTF-8 text in DejaVu Sans at a font size, points: by a table, so that
// each build has the same layout.
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

// A white page as SVG, in points. In few bytes, and the same ones in every build: each element
// states no more than what differs from its group, and strokes of one look that follow each other
// are one path. There are no names and no style sheet, which would meet those of a page that holds
// several figures. Text stays text, in a font that the viewer has, at the width that it has in
// DejaVu Sans.
class Canvas {
 public:
  Canvas(double width, double height);

  // The convex hull of discs, filled, with a white rim of the given width around it.
  void hull(std::span<const Disc> discs, Colour fill, double rim = 0.0);
  void ring(Disc disc, Colour colour, double width);
  // A line through the points with round ends; `dash` is the length of dashes and gaps, 0 for none.
  void line(std::span<const Point> points, Colour colour, double width, double dash = 0.0);
  // A disc in black and white quarters, as centres of mass are marked in drawings.
  void quartered(Disc disc, Colour colour);
  // `at` is on the base line.
  void text(Point at, const std::string& text, double size, Colour colour, Align align);

  // The file's bytes; the canvas is of no use afterwards.
  [[nodiscard]] std::string finish();

 private:
  void dot(const Disc& disc);
  void stroke(Colour colour, double width, double dash, const std::string& data);
  void add(const std::string& look, const std::string& data);
  void end_path();
  void end_texts();

  std::string svg_;
  // the path that is not in svg_ yet: more of its look may follow
  std::string look_;
  std::string data_;
  std::string text_look_;  // of the open group of texts; empty: none is open
};

}  // namespace shigusa::strip
