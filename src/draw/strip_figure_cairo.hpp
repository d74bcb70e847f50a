// SPDX-License-Identifier: MIT
#pragma once

#include <cairo.h>

#include "strip_figure_canvas.hpp"

namespace shigusa::strip {

// Width in the font that this machine has for DejaVu Sans, points.
[[nodiscard]] double cairo_text_width(const std::string& text, double size);

// PNG and PDF, by cairo. Text becomes outlines, which look the same where its font is missing.
class CairoCanvas final : public Canvas {
 public:
  CairoCanvas(FigureFormat format, double width, double height, double pixels_per_point);

  void hull(std::span<const Disc> discs, Colour fill, double rim) override;
  void ring(Disc disc, Colour colour, double width) override;
  void line(std::span<const Point> points, Colour colour, double width, double dash) override;
  void quartered(Disc disc, Colour colour) override;
  void text(Point at, const std::string& text, double size, Colour colour, Align align) override;
  [[nodiscard]] Result<std::string> finish() override;

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
