// SPDX-License-Identifier: MIT
#include "strip_figure_canvas.hpp"

#include <algorithm>
#include <array>
#include <shigusa/math.hpp>

#include "core/index.hpp"
#include "core/text.hpp"

namespace shigusa::strip {
namespace {

// Advance widths of DejaVu Sans from the space to the tilde, in 1/2048 of the font's size.
constexpr double kUnitsPerEm = 2048.0;
constexpr int kFirst = 32;
constexpr std::array<int, 95> kAdvance{
    651,  821,  942,  1716, 1303, 1946, 1597, 563,  799,  799,  1024, 1716, 651,  739,  651,  690,
    1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690,  690,  1716, 1716, 1716, 1087,
    2048, 1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604,  604,  1343, 1141, 1767, 1532, 1612,
    1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799,  690,  799,  1716, 1024,
    1024, 1255, 1300, 1126, 1300, 1260, 721,  1300, 1298, 569,  569,  1186, 569,  1995, 1298, 1253,
    1300, 1300, 842,  1067, 803,  1298, 1212, 1675, 1212, 1212, 1075, 1303, 690,  1303, 1716};
// Widths of letters outside the table: wide enough for accented Latin letters, and the usual width
// of ideographs.
constexpr int kLetter = 1303;
constexpr int kIdeograph = 2048;

bool in_table(char c) {
  const int code = static_cast<unsigned char>(c) - kFirst;
  return code >= 0 && code < static_cast<int>(kAdvance.size());
}

double distance(Point a, Point b) {
  return sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

// Discs without those inside another one, which the hull does not touch.
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

// Angle, counter-clockwise from `angle`, after which `next` reaches further out than `disc`: at the
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

double text_width(std::string_view text, double size) {
  int units = 0;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (in_table(text[0])) {
      units += kAdvance[index(text[0] - kFirst)];
    } else if (length > 1) {
      units += length == 2 ? kLetter : kIdeograph;
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return units * size / kUnitsPerEm;
}

bool has_known_width(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), in_table);
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
  std::size_t first = 0;
  const auto east = [&](std::size_t i) { return discs[i].centre.x + discs[i].radius; };
  for (std::size_t i = 1; i < discs.size(); ++i) first = east(i) > east(first) ? i : first;
  std::size_t current = first;
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
  // the walk began in the middle of the first disc's arc
  if (outline.size() > 1 && current == first) {
    outline.front().from = outline.back().from - kTwoPi;
    outline.pop_back();
  }
  return outline;
}

}  // namespace shigusa::strip
