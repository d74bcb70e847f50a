// SPDX-License-Identifier: MIT
#pragma once

#include "strip_figure_layout.hpp"

namespace shigusa::strip {

// Sizes of text, points.
inline constexpr double kText = 7.0;
inline constexpr double kCaptionText = 8.0;
inline constexpr double kLine = 1.4;  // height of a line of text as a multiple of its size
inline constexpr double kTick = 3.0;  // of a pose's time, below the floor line

// The name of an action below a pose.
struct ActionLabel {
  std::string_view name;
  double x = 0.0;  // points, its middle
  int row = 0;     // from the upper one, so that none covers another
};

// Names of the actions of placed slots on a page of that width.
[[nodiscard]] std::vector<ActionLabel> action_labels(const Strip& strip,
                                                     const std::vector<StripAction>& actions,
                                                     double width);

// A strip placed on its page; heights in points from the page's top.
struct PlacedStrip {
  // borrowed for the call
  const SkeletonMotion* motion = nullptr;
  const StripOverlay* overlay = nullptr;
  const StripSettings* settings = nullptr;

  Strip strip;
  std::vector<std::string> caption;  // lines
  std::vector<ActionLabel> labels{};
  double floor = 0.0;
  double times = 0.0;          // base line of the time labels
  double caption_above = 0.0;  // top of the caption
};

// Paints floor, poses, times and caption.
void paint_strip(Canvas& canvas, const PlacedStrip& placed, double width);

// Paints a legend of the marks used in any of the strips.
void paint_legend(Canvas& canvas, const std::vector<PlacedStrip>& strips, double base);

// Paints a scale bar at the right edge of the page; `metre` in points.
void paint_scale_bar(Canvas& canvas, double metre, double width, double base);

}  // namespace shigusa::strip
