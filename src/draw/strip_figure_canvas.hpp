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

// Width of a line of UTF-8 text in DejaVu Sans at a font size, points. It comes from a table, so
// that every build has the same layout.
[[nodiscard]] double text_width(std::string_view text, double size);

// Whether the table has all letters of a text: those of ASCII. Others count as wide ones.
[[nodiscard]] bool has_known_width(std::string_view text);

// Splits text into lines of at most that width, at spaces, or inside words longer than a line.
[[nodiscard]] std::vector<std::string> wrap_text(std::string_view text, double size, double width);

// Part of a disc's rim, from one angle to a larger one; radians, from the x axis towards y.
struct Arc {
  Disc disc;
  double from = 0.0;
  double to = 0.0;
};

// Outline of the convex hull of one or more discs: arcs joined by common tangents, or a full circle
// about the disc that holds all others.
[[nodiscard]] std::vector<Arc> hull_outline(std::span<const Disc> discs);

// A white page as SVG, in points. The bytes are few and the same in every build: each element
// states only its differences from its group, and consecutive strokes of one look are one path.
// Names and style sheets are avoided, since a page may hold several figures. Text stays text, in a
// font that the viewer has, at its width in DejaVu Sans.
class Canvas {
 public:
  Canvas(double width, double height);

  // The convex hull of discs, filled, with a white rim of the given width around it.
  void hull(std::span<const Disc> discs, Colour fill, double rim = 0.0);
  void ring(Disc disc, Colour colour, double width);
  // Line through the points with round ends; `dash` is the length of dashes and gaps, 0 for none.
  void line(std::span<const Point> points, Colour colour, double width, double dash = 0.0);
  // Disc in black and white quarters, the usual mark of a centre of mass.
  void quartered(Disc disc, Colour colour);
  // `at` is on the base line.
  void text(Point at, const std::string& text, double size, Colour colour, Align align);

  // Returns the file's bytes; the canvas must not be used afterwards.
  [[nodiscard]] std::string finish();

 private:
  void dot(const Disc& disc);
  void stroke(Colour colour, double width, double dash, const std::string& data);
  void add(const std::string& look, const std::string& data);
  void end_path();
  void end_texts();

  std::string svg_;
  // pending path, not in svg_ yet: more of its look may follow
  std::string look_;
  std::string data_;
  std::string text_look_;  // of the open group of texts; empty: no group is open
};

}  // namespace shigusa::strip
