// SPDX-License-Identifier: MIT
#include "figure/strip_figure_cairo.hpp"

#include <gtest/gtest.h>

namespace shigusa::strip {
namespace {

TEST(StripFigureCairo, TableHasTheWidthsOfTheFont) {
  std::string all;
  for (char c = ' '; c <= '~'; ++c) all += c;
  // cairo measures the font itself, which it keeps in 1/64 of a unit
  EXPECT_NEAR(text_width(all, 7.0), cairo_text_width(all, 7.0), 1e-3);
}

}  // namespace
}  // namespace shigusa::strip
