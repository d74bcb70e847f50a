// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <shigusa/math.hpp>
#include <string>

#include "draw/strip_figure_canvas.hpp"

namespace shigusa::strip {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(StripFigureSvg, WidthOfOtherLettersIsAGuess) {
  EXPECT_GT(text_width("仕草", 10.0), 15.0);
  EXPECT_NEAR(text_width("é", 10.0), 6.2, 0.5);
  EXPECT_TRUE(has_known_width("a~ 0"));
  EXPECT_FALSE(has_known_width("é"));
}

TEST(StripFigureSvg, PageHasItsSizeAndEnds) {
  Canvas canvas(481.89, 120.0);
  const std::string svg = canvas.finish();
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_THAT(svg, HasSubstr("width=\"481.89pt\" height=\"120pt\" viewBox=\"0 0 481.89 120\""));
  EXPECT_THAT(svg, EndsWith("</g>\n</svg>\n"));
}

TEST(StripFigureSvg, HullOfTwoEqualDiscsHasTwoHalfTurns) {
  Canvas canvas(100.0, 100.0);
  const Disc discs[] = {{{20.0, 50.0}, 5.0}, {{60.0, 50.0}, 5.0}};
  canvas.hull(discs, {0xa32b19}, 0.0);
  // from the upper tangent around the right disc, in two parts as of half a turn either half could
  // be meant, along the lower tangent and around the left disc
  EXPECT_THAT(
      canvas.finish(),
      HasSubstr("<path fill=\"#a32b19\" stroke=\"none\" "
                "d=\"M60 45a5 5 0 0 1 5 5 5 5 0 0 1-5 5l-40 0a5 5 0 0 1-5-5 5 5 0 0 1 5-5z\"/>"));
}

TEST(StripFigureSvg, DiscThatNearlyHoldsAnotherIsDrawn) {
  Canvas canvas(100.0, 100.0);
  const Disc discs[] = {{{50.0, 50.0}, 10.0}, {{59.0, 50.0}, 1.0001}};
  canvas.hull(discs, {0}, 0.0);
  // a rim of nearly a whole turn is drawn in parts that do not vanish
  EXPECT_GE(count(canvas.finish(), "10 10 0 0 1"), 2u);
}

TEST(StripFigureSvg, ArcThatNobodyCanTellFromALineIsOne) {
  Canvas canvas(100.0, 100.0);
  const Disc discs[] = {{{20.0, 20.0}, 2.0}, {{40.0, 21.0}, 2.0}, {{60.0, 20.0}, 2.0}};
  canvas.hull(discs, {0}, 0.0);
  // both ends in two parts; the middle turns by 0.1 and rises by 0.0025 above its chord
  EXPECT_EQ(count(canvas.finish(), "2 2 0 0 1"), 4u);
}

TEST(StripFigureSvg, RimIsOutsideThePiece) {
  Canvas canvas(100.0, 100.0);
  const Disc disc{{50.0, 50.0}, 10.0};
  canvas.hull({&disc, 1}, {0}, 0.8);
  // painted over the edge of a disc that is larger by half of it
  EXPECT_THAT(canvas.finish(),
              HasSubstr("<path fill=\"#000\" stroke-width=\".8\" d=\"M60.4 50a10.4 10.4 "));
}

TEST(StripFigureSvg, WhiteDotKeepsItsSize) {
  Canvas canvas(100.0, 100.0);
  const Disc disc{{50.0, 40.0}, 2.0};
  canvas.hull({&disc, 1}, {0xffffff}, 0.0);
  // with the rim of 0.7 that all pieces of the group have
  EXPECT_THAT(canvas.finish(), HasSubstr("<circle cx=\"50\" cy=\"40\" r=\"1.65\"/>"));
}

TEST(StripFigureSvg, LinesOfOneLookAreOnePath) {
  Canvas canvas(100.0, 100.0);
  const Point level[] = {{10.0, 20.0}, {30.0, 20.0}};
  const Point plumb[] = {{20.0, 10.0}, {20.0, 30.0}};
  canvas.line(level, {0x0b5c66}, 0.9, 0.0);
  canvas.line(plumb, {0x0b5c66}, 0.9, 0.0);
  canvas.line(level, {0}, 0.9, 0.0);
  const std::string svg = canvas.finish();
  EXPECT_THAT(svg, HasSubstr("d=\"M10 20l20 0M20 10l0 20\""));
  EXPECT_EQ(count(svg, "<path"), 2u);
}

TEST(StripFigureSvg, PiecesWithARimStayApart) {
  Canvas canvas(100.0, 100.0);
  const Disc disc{{50.0, 50.0}, 10.0};
  canvas.hull({&disc, 1}, {0}, 0.7);
  canvas.hull({&disc, 1}, {0}, 0.7);
  EXPECT_EQ(count(canvas.finish(), "<path"), 2u);
}

TEST(StripFigureSvg, TextIsEscapedAndKeepsItsWidth) {
  Canvas canvas(100.0, 100.0);
  canvas.text({10.0, 20.0}, "a<b & ", 8.0, {0}, Align::centre);
  canvas.text({10.0, 20.0}, "仕草\x01", 8.0, {0}, Align::left);
  const std::string svg = canvas.finish();
  EXPECT_THAT(svg, HasSubstr(" text-anchor=\"middle\" textLength=\""));
  EXPECT_THAT(svg, HasSubstr(">a&lt;b &amp; </text>"));
  EXPECT_THAT(svg, HasSubstr("<text x=\"10\" y=\"20\">仕草</text>"));
}

TEST(StripFigureSvg, TextsOfOneLookShareIt) {
  Canvas canvas(100.0, 100.0);
  const Disc disc{{50.0, 50.0}, 10.0};
  canvas.text({10.0, 20.0}, "a", 8.0, {0}, Align::left);
  canvas.text({10.0, 30.0}, "b", 8.0, {0}, Align::left);
  canvas.hull({&disc, 1}, {0}, 0.7);
  const std::string svg = canvas.finish();
  EXPECT_EQ(count(svg, "font-size"), 1u);
  EXPECT_EQ(count(svg, "<g"), count(svg, "</g>"));
  EXPECT_LT(svg.find("b</text>\n</g>"), svg.find("<path"));
}

TEST(StripFigureSvg, NumbersAreShortAndZeroHasNoSign) {
  Canvas canvas(100.0, 100.0);
  const Point points[] = {{-0.001, 1.0 / 3.0}, {2.5, -4.0}, {3.0, -3.75}};
  canvas.line(points, {0}, 0.5, 1.8);
  EXPECT_THAT(canvas.finish(), HasSubstr("stroke-dasharray=\"1.8\" d=\"M0 .33l2.5-4.33.5.25\""));
}

TEST(StripFigureSvg, StepsDoNotAddUpTheirRounding) {
  Canvas canvas(100.0, 100.0);
  std::vector<Point> points;
  for (int i = 0; i <= 300; ++i) points.push_back({i / 3.0, 0.0});
  canvas.line(points, {0}, 0.5, 0.0);
  const std::string svg = canvas.finish();
  // a third is .33 or .34, so that every third point is where it belongs
  EXPECT_EQ(count(svg, ".34 0"), 100u);
}

TEST(StripFigureSvg, LineThatGoesNowhereIsADot) {
  Canvas canvas(100.0, 100.0);
  const Point points[] = {{10.0, 20.0}, {10.001, 20.0}};
  canvas.line(points, {0}, 0.5, 0.0);
  EXPECT_THAT(canvas.finish(), HasSubstr("d=\"M10 20z\""));
}

}  // namespace
}  // namespace shigusa::strip
