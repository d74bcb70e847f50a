// SPDX-License-Identifier: MIT
#pragma once

#include "strip_figure_canvas.hpp"

namespace shigusa::strip {

// Width in DejaVu Sans, points; what is not ASCII counts as a wide letter.
[[nodiscard]] double svg_text_width(const std::string& text, double size);

// SVG without a library, for builds without cairo. Text stays text, which is drawn in a font that
// the viewer has, at the width that it has in DejaVu Sans.
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
  std::string svg_;
};

}  // namespace shigusa::strip
