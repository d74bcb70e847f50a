// SPDX-License-Identifier: MIT
#pragma once

#include "strip_figure_canvas.hpp"

namespace shigusa::strip {

// SVG in few bytes, and the same ones in every build: each element states no more than what differs
// from its group, and strokes of one look that follow each other are one path. There are no names
// and no style sheet, which would meet those of a page that holds several figures. Text stays text,
// in a font that the viewer has, at the width that it has in DejaVu Sans.
class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(double width, double height);

  void hull(std::span<const Disc> discs, Colour fill, double rim) override;
  void ring(Disc disc, Colour colour, double width) override;
  void line(std::span<const Point> points, Colour colour, double width, double dash) override;
  void quartered(Disc disc, Colour colour) override;
  void text(Point at, const std::string& text, double size, Colour colour, Align align) override;
  [[nodiscard]] Result<std::string> finish() override;

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
