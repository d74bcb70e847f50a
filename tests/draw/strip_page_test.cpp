// SPDX-License-Identifier: MIT
#include "strip_support.hpp"

namespace shigusa {
namespace {

using namespace strip_support;

std::string page(const std::vector<MotionStrip>& strips) { return draw_strips(strips).value(); }

MotionStrip captioned(const SkeletonMotion& motion, const std::string& caption) {
  MotionStrip strip{motion, {}, {}};
  strip.overlay.caption = caption;
  return strip;
}

TEST(StripPage, PageOfOneStripIsThatStrip) {
  const SkeletonMotion motion = reaching(12);
  const StripOverlay overlay = full_overlay(motion);
  EXPECT_EQ(page({{motion, overlay, {}}}), svg(motion, overlay));
}

TEST(StripPage, StripsStandUnderEachOtherWithTheirCaptions) {
  const std::string text =
      page({captioned(reaching(30), "first"), captioned(standing(1), "second")});
  const double first = base_of(text, "first");
  const double second = base_of(text, "second");
  EXPECT_LT(first, second);
  EXPECT_TRUE(within_page(text));
  int above = 0;
  int below = 0;
  for (const Path& piece : rims(text)) {
    if (piece.bottom() < first) ++above;
    if (piece.top() > first && piece.bottom() < second) ++below;
  }
  EXPECT_EQ(above + below, static_cast<int>(rims(text).size()));
  EXPECT_EQ(above, 7 * below);
}

TEST(StripPage, MetreIsAsLongInEachStrip) {
  // alone, either would fill the page
  MotionStrip few = captioned(standing(1), "few");
  MotionStrip many = captioned(in_centimetres(reaching(30)), "many");
  many.settings.metres_per_unit = 0.01;
  many.settings.poses = 12;
  const std::string text = page({few, many});
  const auto height = [&](double above, double below) {
    double top = 1e9;
    double bottom = 0.0;
    for (const Path& piece : rims(text)) {
      if (piece.bottom() < above || piece.top() > below) continue;
      top = std::min(top, piece.top());
      bottom = std::max(bottom, piece.bottom());
    }
    return bottom - top;
  };
  const double middle = base_of(text, "few");
  EXPECT_NEAR(height(0.0, middle), height(middle, 1e9), 2.0 * kSameArc);
}

TEST(StripPage, LegendNamesTheMarksOfAllStripsOnce) {
  MotionStrip first = captioned(standing(1), "");
  first.overlay.goals = {{0.0, 1.0, 0.3}};
  MotionStrip second = first;
  second.overlay.hand_path = {{0.0, 1.0, 0.3}};
  const std::vector<Words> all = words(page({first, second}));
  const auto count = [&](const std::string& name) {
    return std::count_if(all.begin(), all.end(), [&](const Words& w) { return w.text == name; });
  };
  EXPECT_EQ(count("goal"), 1);
  EXPECT_EQ(count("path"), 1);
  EXPECT_EQ(count("centre of mass"), 0);
}

TEST(StripPage, RefusalsNameTheStrip) {
  const auto refused = [](const std::vector<MotionStrip>& strips) {
    const auto figure = draw_strips(strips);
    return figure ? "drawn" : figure.error().to_string();
  };
  const MotionStrip good = captioned(standing(1), "");
  EXPECT_EQ(refused({}), "strips: 0 given; 1 to 12 allowed");
  EXPECT_EQ(refused(std::vector<MotionStrip>(13, good)), "strips: 13 given; 1 to 12 allowed");
  MotionStrip bad = good;
  bad.settings.poses = 0;
  EXPECT_EQ(refused({good, bad}), "strip 2: poses: 0 given; 1 to 60 allowed");
  MotionStrip wide = good;
  wide.settings.width_mm = 200.0;
  EXPECT_EQ(refused({good, wide}),
            "strip 2: width_mm: 200 given and 170 for strip 1; the strips of a page share it");
}

}  // namespace
}  // namespace shigusa
