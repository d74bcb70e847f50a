// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/draw.hpp>
#include <shigusa/math.hpp>

#include "strip_figure_painter.hpp"

namespace shigusa {
namespace {

using namespace strip;

// Page sizes, points.
constexpr double kBelowText = 0.4 * kText;  // descent of letters below their base line
constexpr double kAboveLegend = 1.7 * kText;
constexpr double kBetweenStrips = 9.0;

// A page of strips under each other, all at one scale.
class Page {
 public:
  explicit Page(const StripSettings& settings) : width_(settings.width_mm * kPointsPerMm) {}

  [[nodiscard]] Result<void> add(const SkeletonMotion& motion, const StripOverlay& overlay,
                                 const StripSettings& settings);
  // Draws one or more strips.
  [[nodiscard]] std::string draw();

 private:
  void place();
  // Places a strip; returns its lower end.
  [[nodiscard]] double place(PlacedStrip& placed, double top) const;

  double width_;
  std::vector<PlacedStrip> strips_;
  double metre_ = 0.0;   // points
  double legend_ = 0.0;  // base line of the legend
  double height_ = 0.0;
};

Result<void> Page::add(const SkeletonMotion& motion, const StripOverlay& overlay,
                       const StripSettings& settings) {
  SHG_TRY(check_strip(motion, overlay, settings));
  PlacedStrip placed{&motion, &overlay, &settings, {}, {}};
  SHG_TRY_ASSIGN(placed.strip, lay_out(motion, overlay, settings));
  placed.caption = wrap_text(overlay.caption, kCaptionText, width_ - 2.0 * kMargin);
  const double metre = placed.strip.largest_scale(width_) / settings.metres_per_unit;
  metre_ = strips_.empty() ? metre : min(metre_, metre);
  strips_.push_back(std::move(placed));
  return {};
}

double Page::place(PlacedStrip& placed, double top) const {
  const double scale = metre_ * placed.settings->metres_per_unit;
  place_slots(placed.strip, width_, scale);
  placed.floor = top + scale * max(placed.strip.top, 0.0);
  placed.times = placed.floor - scale * min(placed.strip.bottom, 0.0) + kTick + kLine * kText;
  placed.labels = action_labels(placed.strip, placed.overlay->actions, width_);
  int rows = 0;
  for (const ActionLabel& label : placed.labels) rows = std::max(rows, label.row + 1);
  placed.caption_above = placed.times + rows * kLine * kText + kBelowText;
  if (placed.caption.empty()) return placed.caption_above;
  const double lines = static_cast<double>(placed.caption.size());
  return placed.caption_above + lines * kLine * kCaptionText + kBelowText;
}

void Page::place() {
  double end = kMargin - kBetweenStrips;
  for (PlacedStrip& placed : strips_) end = place(placed, end + kBetweenStrips);
  legend_ = end + kAboveLegend;
  height_ = legend_ + kBelowText + kMargin;
}

std::string Page::draw() {
  place();
  Canvas canvas(width_, height_);
  for (const PlacedStrip& placed : strips_) paint_strip(canvas, placed, width_);
  paint_legend(canvas, strips_, legend_);
  paint_scale_bar(canvas, metre_, width_, legend_);
  return canvas.finish();
}

Result<void> check_width(double first, double width) {
  if (width == first) return {};
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("{} given and {} for strip 1; the strips of a page share it", width, first),
      "width_mm");
}

}  // namespace

Result<std::string> draw_strip(const SkeletonMotion& motion, const StripOverlay& overlay,
                               const StripSettings& settings) {
  Page page(settings);
  SHG_TRY(page.add(motion, overlay, settings));
  return page.draw();
}

Result<std::string> draw_strips(const std::vector<MotionStrip>& strips) {
  if (strips.empty() || strips.size() > kPageMaxStrips) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} given; 1 to {} allowed", strips.size(), kPageMaxStrips), "strips");
  }
  const StripSettings& first = strips.front().settings;
  Page page(first);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const MotionStrip& strip = strips[i];
    Result<void> added =
        i == 0 ? Result<void>{} : check_width(first.width_mm, strip.settings.width_mm);
    if (added) added = page.add(strip.motion, strip.overlay, strip.settings);
    if (added) continue;
    const Error& error = added.error();
    return fail(error.code, error.message, fmt::format("strip {}: {}", i + 1, error.place));
  }
  return page.draw();
}

}  // namespace shigusa
