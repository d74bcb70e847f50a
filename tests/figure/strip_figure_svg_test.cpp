// SPDX-License-Identifier: MIT
// The drawing of builds without cairo; those with it have it too, and compare.
#include "figure/strip_figure_svg.hpp"

#include <gtest/gtest.h>

#include <shigusa/scalar.hpp>
#include <string>

namespace shigusa::strip {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++found;
  }
  return found;
}

TEST(StripFigureSvg, WidthsAreThoseOfTheFont) {
  std::string all;
  for (char c = ' '; c <= '~'; ++c) all += c;
  // text_width is cairo's where the build has it, which measures the font itself
  EXPECT_NEAR(svg_text_width(all, 7.0), text_width(all, 7.0), 1e-3);
}

TEST(StripFigureSvg, WidthOfOtherLettersIsAGuess) {
  EXPECT_GT(svg_text_width("仕草", 10.0), 15.0);
  EXPECT_NEAR(svg_text_width("é", 10.0), 6.2, 0.5);
}

TEST(StripFigureSvg, PageHasItsSizeAndEnds) {
  SvgCanvas canvas(481.89, 120.0);
  const std::string svg = canvas.finish().value();
  EXPECT_EQ(svg.find("<?xml"), 0u);
  EXPECT_NE(svg.find("width=\"481.89pt\" height=\"120pt\" viewBox=\"0 0 481.89 120\""),
            std::string::npos);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST(StripFigureSvg, HullOfTwoEqualDiscsHasTwoHalfTurns) {
  SvgCanvas canvas(100.0, 100.0);
  const Disc discs[] = {{{20.0, 50.0}, 5.0}, {{60.0, 50.0}, 5.0}};
  canvas.hull(discs, {0xa32b19}, 0.0);
  const std::string svg = canvas.finish().value();
  EXPECT_NE(svg.find("fill=\"#a32b19\""), std::string::npos);
  // from the east of the right disc down, along the lower tangent, around and back
  EXPECT_NE(svg.find("d=\"M65,50A5 5 0 0 1 60,55L20,55"), std::string::npos) << svg;
  EXPECT_NE(svg.find("A5 5 0 0 1 15,50A5 5 0 0 1 20,45L60,45A5 5 0 0 1 65,50Z\""),
            std::string::npos)
      << svg;
}

TEST(StripFigureSvg, DiscThatAllButHoldsAnotherIsDrawn) {
  SvgCanvas canvas(100.0, 100.0);
  const Disc discs[] = {{{50.0, 50.0}, 10.0}, {{59.0, 50.0}, 1.0001}};
  canvas.hull(discs, {0}, 0.0);
  // a rim of nearly a whole turn is told in parts that do not vanish
  EXPECT_GE(count(canvas.finish().value(), "A10 10"), 2u);
}

TEST(StripFigureSvg, RimIsPaintedUnderThePiece) {
  SvgCanvas canvas(100.0, 100.0);
  const Disc disc{{50.0, 50.0}, 10.0};
  canvas.hull({&disc, 1}, {0}, 0.7);
  const std::string svg = canvas.finish().value();
  EXPECT_LT(svg.find("stroke=\"#ffffff\" stroke-width=\"1.4\""), svg.find("fill=\"#000000\""));
}

TEST(StripFigureSvg, TextIsEscapedAndKeepsItsWidth) {
  SvgCanvas canvas(100.0, 100.0);
  canvas.text({10.0, 20.0}, "a<b & \x01", 8.0, {0}, Align::centre);
  const std::string svg = canvas.finish().value();
  EXPECT_NE(svg.find(">a&lt;b &amp; </text>"), std::string::npos) << svg;
  EXPECT_NE(svg.find("text-anchor=\"middle\""), std::string::npos);
  EXPECT_NE(svg.find("textLength=\""), std::string::npos);
}

TEST(StripFigureSvg, NumbersAreShortAndZeroHasNoSign) {
  SvgCanvas canvas(100.0, 100.0);
  const Point points[] = {{-0.001, 1.0 / 3.0}, {2.5, -4.0}};
  canvas.line(points, {0}, 0.5, 1.8);
  const std::string svg = canvas.finish().value();
  EXPECT_NE(svg.find("stroke-dasharray=\"1.8\" d=\"M0,0.33L2.5,-4\""), std::string::npos) << svg;
}

}  // namespace
}  // namespace shigusa::strip
