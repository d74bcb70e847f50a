// SPDX-License-Identifier: MIT
#include "draw/strip_figure_cairo.hpp"

#include <gtest/gtest.h>

namespace shigusa::strip {
namespace {

TEST(StripFigureCairo, TableHasTheWidthsOfTheFont) {
  std::string all;
  for (char c = ' '; c <= '~'; ++c) all += c;
  // cairo measures the font itself, which it keeps in 1/64 of a unit
  EXPECT_NEAR(text_width(all, 7.0), cairo_text_width(all, 7.0), 1e-3);
}

// The lightness (0 to 255) of a PNG's pixels.
class Pixels {
 public:
  explicit Pixels(std::string png) : png_(std::move(png)) {
    const auto read = [](void* from, unsigned char* to, unsigned int size) {
      std::string& rest = *static_cast<std::string*>(from);
      if (rest.size() < size) return CAIRO_STATUS_READ_ERROR;
      rest.copy(reinterpret_cast<char*>(to), size);
      rest.erase(0, size);
      return CAIRO_STATUS_SUCCESS;
    };
    surface_ = cairo_image_surface_create_from_png_stream(read, &png_);
  }
  Pixels(const Pixels&) = delete;
  ~Pixels() { cairo_surface_destroy(surface_); }

  [[nodiscard]] int at(double x, double y) const {
    const unsigned char* rows = cairo_image_surface_get_data(surface_);
    return rows[cairo_image_surface_get_stride(surface_) * static_cast<int>(y) +
                4 * static_cast<int>(x)];
  }

 private:
  std::string png_;
  cairo_surface_t* surface_;
};

TEST(StripFigureCairo, OfAQuarteredDiscTwoOppositeQuartersAreFilled) {
  CairoCanvas canvas(FigureFormat::png, 100.0, 100.0, 1.0);
  canvas.quartered({{50.0, 50.0}, 40.0}, {0});
  const Pixels pixels(canvas.finish().value());
  for (int degree = 5; degree < 360; degree += 10) {
    const SinCos<double> way = sin_cos(radians(degree));
    const bool filled = degree % 180 < 90;
    EXPECT_EQ(pixels.at(50.0 + 25.0 * way.cos, 50.0 + 25.0 * way.sin), filled ? 0 : 255) << degree;
    EXPECT_EQ(pixels.at(50.0 + 40.0 * way.cos, 50.0 + 40.0 * way.sin), 0) << degree;  // the rim
    EXPECT_EQ(pixels.at(50.0 + 48.0 * way.cos, 50.0 + 48.0 * way.sin), 255) << degree;
  }
}

}  // namespace
}  // namespace shigusa::strip
