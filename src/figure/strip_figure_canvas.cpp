// SPDX-License-Identifier: MIT
#include "strip_figure_canvas.hpp"

#include <algorithm>
#include <shigusa/scalar.hpp>

#include "core/text.hpp"

#ifdef SHIGUSA_HAS_CAIRO
#include "strip_figure_cairo.hpp"
#else
#include "strip_figure_svg.hpp"
#endif

namespace shigusa::strip {
namespace {

double distance(Point a, Point b) {
  return sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

// Without the discs that lie inside another one, which no hull touches.
std::vector<Disc> outermost(std::span<const Disc> discs) {
  constexpr double kTolerance = 1e-6;
  std::vector<Disc> kept;
  for (const Disc& disc : discs) {
    const auto holds = [](const Disc& outer, const Disc& inner) {
      return distance(outer.centre, inner.centre) + inner.radius <= outer.radius + kTolerance;
    };
    bool inside = false;
    for (const Disc& other : kept) inside = inside || holds(other, disc);
    if (inside) continue;
    std::erase_if(kept, [&](const Disc& other) { return holds(disc, other); });
    kept.push_back(disc);
  }
  return kept;
}

// The angle, going around from `angle`, after which `next` reaches further out than `disc`: at the
// common tangent u·(c' - c) = r - r'. Result in [0, 2π).
double turn_to(const Disc& disc, const Disc& next, double angle) {
  const double dx = next.centre.x - disc.centre.x;
  const double dy = next.centre.y - disc.centre.y;
  const double tangent =
      atan2(dy, dx) - acos((disc.radius - next.radius) / sqrt(dx * dx + dy * dy));
  double turn = tangent - angle;
  while (turn < 0.0) turn += kTwoPi;
  while (turn >= kTwoPi - 1e-9) turn -= kTwoPi;
  return max(turn, 0.0);
}

}  // namespace

double text_width(const std::string& text, double size) {
#ifdef SHIGUSA_HAS_CAIRO
  return cairo_text_width(text, size);
#else
  return svg_text_width(text, size);
#endif
}

std::vector<std::string> wrap_text(std::string_view text, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    const bool space = text[0] == ' ' || text[0] == '\t' || text[0] == '\n' || text[0] == '\r';
    const bool repeated = space && (line.empty() || line.back() == ' ');
    if (!repeated) line += space ? " " : text.substr(0, length);
    text.remove_prefix(length);
    if (space || text_width(line, size) <= width) continue;
    const std::size_t gap = line.rfind(' ');
    const std::size_t cut = gap != std::string::npos ? gap : line.size() - length;
    if (cut > 0) lines.push_back(line.substr(0, cut));
    line.erase(0, gap != std::string::npos ? cut + 1 : cut);
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::vector<Arc> hull_outline(std::span<const Disc> all) {
  const std::vector<Disc> discs = outermost(all);
  std::vector<Arc> outline;
  std::size_t current = 0;
  const auto east = [&](std::size_t i) { return discs[i].centre.x + discs[i].radius; };
  for (std::size_t i = 1; i < discs.size(); ++i) current = east(i) > east(current) ? i : current;
  double angle = 0.0;
  for (std::size_t step = 0; step <= 2 * discs.size() && angle < kTwoPi; ++step) {
    double turn = kTwoPi - angle;
    std::size_t next = current;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const double t = i == current ? kTwoPi : turn_to(discs[current], discs[i], angle);
      if (t < turn) {
        turn = t;
        next = i;
      }
    }
    outline.push_back({discs[current], angle, angle + turn});
    angle = next == current ? kTwoPi : angle + turn;
    current = next;
  }
  return outline;
}

Result<std::unique_ptr<Canvas>> make_canvas(FigureFormat format, double width, double height,
                                            double pixels_per_point) {
#ifdef SHIGUSA_HAS_CAIRO
  return std::make_unique<CairoCanvas>(format, width, height, pixels_per_point);
#else
  (void)pixels_per_point;
  if (format != FigureFormat::svg) {
    return fail(ErrorCode::unsupported, "this build has no cairo, which draws PNG and PDF; use svg",
                "strip figure");
  }
  return std::make_unique<SvgCanvas>(width, height);
#endif
}

}  // namespace shigusa::strip
