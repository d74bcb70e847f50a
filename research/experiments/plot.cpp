// SPDX-License-Identifier: MIT
#include "plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.hpp"

namespace shigusa::bench {
namespace {

// px
constexpr double kLeft = 62, kTop = 14, kBottom = 46, kWide = 470, kHigh = 330, kNames = 150;
constexpr double kNameHeight = 13;

// distinguishable with any colour vision, as far as ten can be (P. Tol, Colour schemes, 2021)
constexpr std::array kColours{"#332288", "#CC6677", "#117733", "#DDCC77", "#88CCEE",
                              "#882255", "#44AA99", "#999933", "#AA4499", "#777777"};

class Plot {
 public:
  Plot(const PlotAxis& x, const PlotAxis& y) : x_(x), y_(y) {
    SHG_CHECK(x.ticks.size() >= 2 && y.ticks.size() >= 2, "an axis has two ticks or more");
    body_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n",
        kLeft + kWide + kNames, kTop + kHigh + kBottom);
    for (const double tick : x.ticks) {
      line(at_x(tick), kTop, at_x(tick), kTop + kHigh, "#e4e4e4", 1.0);
      text(at_x(tick), kTop + kHigh + 15, fmt::format("{:g}", tick), "middle", "#222");
    }
    for (const double tick : y.ticks) {
      line(kLeft, at_y(tick), kLeft + kWide, at_y(tick), "#e4e4e4", 1.0);
      text(kLeft - 6, at_y(tick) + 4, fmt::format("{:g}", tick), "end", "#222");
    }
    text(kLeft + kWide / 2, kTop + kHigh + 35, x.label, "middle", "#222");
    body_ += fmt::format(
        "<text transform=\"translate(15 {:.1f}) rotate(-90)\" text-anchor=\"middle\" "
        "fill=\"#222\">{}</text>\n",
        kTop + kHigh / 2, y.label);
  }

  [[nodiscard]] double at_x(double value) const { return kLeft + kWide * share(x_, value); }
  [[nodiscard]] double at_y(double value) const { return kTop + kHigh * (1.0 - share(y_, value)); }

  void line(double x1, double y1, double x2, double y2, std::string_view colour, double width,
            std::string_view dashes = "none") {
    body_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{:g}\" stroke-dasharray=\"{}\"/>\n",
        x1, y1, x2, y2, colour, width, dashes);
  }
  void text(double x, double y, std::string_view words, std::string_view anchor,
            std::string_view colour) {
    body_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n", x,
                    y, anchor, colour, words);
  }
  void dot(double x, double y, std::string_view colour) {
    body_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\" fill-opacity=\"0.75\"/>\n", x, y,
        colour);
  }
  [[nodiscard]] std::string finished() const { return body_ + "</svg>\n"; }

 private:
  static double share(const PlotAxis& axis, double value) {
    const double low = std::log(axis.ticks.front());
    const double high = std::log(axis.ticks.back());
    return std::clamp((std::log(value) - low) / (high - low), 0.0, 1.0);
  }

  PlotAxis x_;
  PlotAxis y_;
  std::string body_;
};

std::string_view colour(std::size_t index) { return kColours[index % kColours.size()]; }

// Label positions without overlap, in order, as near to `wanted` as possible.
std::vector<double> spread_out(std::vector<double> wanted) {
  std::vector<std::size_t> order(wanted.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    wanted[order[k]] = std::max(wanted[order[k]], wanted[order[k - 1]] + kNameHeight);
  }
  double floor = kTop + kHigh;
  for (std::size_t k = order.size(); k-- > 0; floor = wanted[order[k]] - kNameHeight) {
    wanted[order[k]] = std::min(wanted[order[k]], floor);
  }
  return wanted;
}

}  // namespace

std::string line_plot(const PlotAxis& x, const PlotAxis& y, const std::vector<PlotSeries>& lines) {
  Plot plot(x, y);
  std::vector<double> ends;
  for (std::size_t s = 0; s < lines.size(); ++s) {
    const PlotSeries& of = lines[s];
    for (std::size_t i = 1; i < of.x.size(); ++i) {
      plot.line(plot.at_x(of.x[i - 1]), plot.at_y(of.y[i - 1]), plot.at_x(of.x[i]),
                plot.at_y(of.y[i]), colour(s), s == 0 ? 3.0 : 1.6);
    }
    ends.push_back(plot.at_y(of.y.back()));
  }
  const std::vector<double> names = spread_out(ends);
  for (std::size_t s = 0; s < lines.size(); ++s) {
    plot.line(kLeft + kWide, ends[s], kLeft + kWide + 12, names[s], colour(s), 0.8);
    plot.text(kLeft + kWide + 15, names[s] + 4, lines[s].name, "start", colour(s));
  }
  return plot.finished();
}

std::string dot_plot(const PlotAxis& x, const PlotAxis& y, const std::vector<PlotSeries>& dots,
                     const std::vector<PlotGuide>& guides) {
  Plot plot(x, y);
  for (const PlotGuide& guide : guides) {
    const double low = std::max(x.ticks.front(), y.ticks.front() / guide.factor);
    const double high = std::min(x.ticks.back(), y.ticks.back() / guide.factor);
    plot.line(plot.at_x(low), plot.at_y(guide.factor * low), plot.at_x(high),
              plot.at_y(guide.factor * high), "#888", 1.0, "5 4");
    plot.text(plot.at_x(high) + 4, plot.at_y(guide.factor * high) + 4, guide.name, "start", "#666");
  }
  for (std::size_t s = 0; s < dots.size(); ++s) {
    const PlotSeries& of = dots[s];
    for (std::size_t i = 0; i < of.x.size(); ++i) {
      plot.dot(plot.at_x(of.x[i]), plot.at_y(of.y[i]), colour(s));
    }
    const double row = kTop + 14 + 16 * static_cast<double>(s);
    plot.dot(kLeft + 12, row - 4, colour(s));
    plot.text(kLeft + 20, row, of.name, "start", "#222");
  }
  return plot.finished();
}

}  // namespace shigusa::bench
