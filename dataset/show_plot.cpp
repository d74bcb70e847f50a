// SPDX-License-Identifier: MIT
#include "show_plot.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "formats/xml.hpp"

namespace shigusa {

std::string grouped(std::uint64_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, ",");
  }
  return digits;
}

Ticks ticks(double low, double high, int most) {
  constexpr std::array kRound{1.0, 2.0, 2.5, 5.0};
  Ticks found;
  if (!(high > low)) return found;
  for (double power = 1e-6; power < 1e12; power *= 10.0) {
    for (const double round : kRound) {
      found.step = power * round;
      if ((high - low) / found.step > most - 1) continue;
      for (double k = std::ceil(low / found.step - 1e-9);
           k * found.step <= high + 1e-9 * found.step; k += 1.0) {
        found.at.push_back(k * found.step);
      }
      return found;
    }
  }
  return found;
}

std::string tick_label(double value, double step) {
  int digits = 0;
  for (double s = step; digits < 6 && s - std::floor(s + 1e-9) > 1e-6 * s; s *= 10.0) ++digits;
  std::string label = fmt::format("{:.{}f}", value == 0.0 ? 0.0 : value, digits);
  if (label.starts_with('-')) label.replace(0, 1, "\u2212");
  return label;
}

std::string axes(const PlotFrame& frame, std::string_view x_name, std::string_view y_name) {
  std::string grid;
  std::string labels;
  const double right = frame.left + frame.width;
  const double bottom = frame.top + frame.height;
  const Ticks across = ticks(frame.low_x, frame.high_x, 7);
  for (const double value : across.at) {
    const double x = frame.x(value);
    grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, frame.top, bottom);
    labels += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" class="mid">{}</text>)", x, bottom + 15.0,
                          tick_label(value, across.step));
  }
  const Ticks up = ticks(frame.low_y, frame.high_y, 7);
  for (const double value : up.at) {
    const double y = frame.y(value);
    grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", frame.left, y, right);
    labels += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" class="end">{}</text>)", frame.left - 6.0,
                          y + 4.0, tick_label(value, up.step));
  }
  labels += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" class="mid name">{}</text>)",
                        frame.left + frame.width / 2.0, bottom + 32.0, xml_escaped(x_name));
  labels += fmt::format(
      R"svg(<text transform="translate(11 {:.1f}) rotate(-90)" class="mid name">{}</text>)svg",
      frame.top + frame.height / 2.0, xml_escaped(y_name));
  return fmt::format(R"(<path class="grid" d="{}"/>{})", grid, labels);
}

std::string figure(const Picture& picture) {
  return fmt::format(
      "<figure>\n<figcaption><h3>{}</h3></figcaption>\n"
      "<svg viewBox=\"0 0 {:g} {:g}\" role=\"img\" "
      "aria-label=\"{}\">{}</svg>\n<p>{}</p>\n</figure>\n",
      xml_escaped(picture.title), kPlotWidth, picture.height, xml_escaped(picture.says),
      picture.body, picture.caption);
}

void Marks::add(double x, double y) {
  switch (shape_) {
    case MarkShape::dot:
      path_ += fmt::format("M{:.1f} {:.1f}h0", x, y);
      break;
    case MarkShape::triangle:
      path_ += fmt::format("M{:.1f} {:.1f}l3.6 6.4h-7.2z", x, y - 4.0);
      break;
    case MarkShape::cross:
      path_ += fmt::format("M{:.1f} {:.1f}l6 6m0-6l-6 6", x - 3.0, y - 3.0);
      break;
  }
}

std::string Marks::svg(std::string_view style) const {
  constexpr std::array kStyles{"dots", "triangles", "crosses"};
  if (path_.empty()) return {};
  return fmt::format(R"(<path class="{} {}" d="{}"/>)", kStyles[static_cast<std::size_t>(shape_)],
                     style, path_);
}

}  // namespace shigusa
