// SPDX-License-Identifier: MIT
#include "cost_plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"

namespace shigusa {
namespace {

constexpr std::array kRebaBands{ScaleBand{1, "g1"}, ScaleBand{3, "g2"}, ScaleBand{7, "y"},
                                ScaleBand{10, "o"}, ScaleBand{15, "r"}};
constexpr std::array kRulaBands{ScaleBand{2, "g1"}, ScaleBand{4, "y"}, ScaleBand{6, "o"},
                                ScaleBand{7, "r"}};
constexpr std::array kCompressionBands{ScaleBand{3.4, "g1"}, ScaleBand{6.4, "y"},
                                       ScaleBand{10, "r"}};
constexpr std::array kMomentBands{ScaleBand{40, "g1"}, ScaleBand{80, "y"}, ScaleBand{135, "o"},
                                  ScaleBand{250, "r"}};
constexpr std::array kLiftBands{ScaleBand{1, "g1"}, ScaleBand{3, "y"}, ScaleBand{5, "r"}};

// Size of a plot and the room for its labels, in the SVG's units.
constexpr double kPlotWidth = 340.0;
constexpr double kPlotHeight = 92.0;
constexpr double kValueRoom = 26.0;
constexpr double kTimeRoom = 14.0;
constexpr double kNameRoom = 12.0;

constexpr std::array<std::string_view, 2> kLineStyles{"", " stroke-dasharray=\"4 2\""};

// Space (s) between the labels of a plot's time.
double time_step(double duration) {
  for (const double step : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 60.0}) {
    if (duration <= 8.0 * step) return step;
  }
  return duration;
}

}  // namespace

const CostScale kRebaScale{"REBA", "", kRebaBands};
const CostScale kRulaScale{"RULA", "", kRulaBands};
const CostScale kCompressionScale{"L5/S1 compression", "kN", kCompressionBands};
const CostScale kMomentScale{"L5/S1 moment", "N·m", kMomentBands};
const CostScale kLiftScale{"Lifting index", "", kLiftBands};

std::string_view colour_of(const CostScale& scale, double value) {
  for (const ScaleBand& band : scale.bands) {
    if (value <= band.most) return band.colour;
  }
  return scale.bands.back().colour;
}

std::string bar_row(const CostScale& scale, double value, std::string_view about) {
  constexpr double kBar = 200.0;
  const double most = scale.bands.back().most;
  std::string bar;
  double from = 0.0;
  for (const ScaleBand& band : scale.bands) {
    bar += fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"4\" width=\"{:.1f}\" height=\"8\"/>",
                       band.colour, kBar * from / most, kBar * (band.most - from) / most);
    from = band.most;
  }
  const double at = kBar * std::clamp(value / most, 0.0, 1.0);
  bar += fmt::format("<path class=\"mark\" d=\"M{0:.1f} 0v16\"/>", at);
  return fmt::format(
      "<tr><th>{}</th><td class=\"bar\"><svg viewBox=\"-2 0 204 16\" role=\"img\" "
      "aria-label=\"{} of {:g}\">{}</svg></td><td class=\"value {}\">{:.3g} {}</td><td>{}</td>"
      "</tr>\n",
      scale.name, fmt::format("{:.4g}", value), most, bar, colour_of(scale, value), value,
      scale.unit, about);
}

std::string plot_over_time(const CostScale& scale, std::span<const PlotLine> lines, double duration,
                           std::span<const double> begins) {
  const double most = scale.bands.back().most;
  const double height = kPlotHeight - kNameRoom - kTimeRoom;
  const auto x_of = [&](double time) {
    return kValueRoom + (kPlotWidth - kValueRoom - 4.0) * (duration > 0.0 ? time / duration : 0.0);
  };
  const auto y_of = [&](double value) {
    return kNameRoom + height * (1.0 - std::clamp(value / most, 0.0, 1.0));
  };
  std::string svg = fmt::format("<svg viewBox=\"0 0 {:g} {:g}\" class=\"plot\" role=\"img\">",
                                kPlotWidth, kPlotHeight);
  double from = 0.0;
  for (const ScaleBand& band : scale.bands) {
    svg += fmt::format(
        "<rect class=\"{} pale\" x=\"{:g}\" y=\"{:.1f}\" width=\"{:g}\" height=\"{:.1f}\"/>"
        "<text x=\"{:g}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>",
        band.colour, kValueRoom, y_of(band.most), kPlotWidth - kValueRoom - 4.0,
        y_of(from) - y_of(band.most), kValueRoom - 3.0, y_of(band.most) + 3.0, band.most);
    from = band.most;
  }
  for (const double time : begins) {
    svg += fmt::format("<path class=\"begin\" d=\"M{:.1f} {:g}v{:g}\"/>", x_of(time), kNameRoom,
                       height);
  }
  std::string legend;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::string path;
    bool drawn = false;
    const auto& values = lines[k].values;
    for (std::size_t f = 0; f < values.size(); ++f) {
      const bool has = values[f].has_value();
      if (has) {
        const double time = duration * static_cast<double>(f) /
                            static_cast<double>(std::max<std::size_t>(values.size(), 2) - 1);
        path += fmt::format("{}{:.1f} {:.1f}", drawn ? "L" : "M", x_of(time), y_of(*values[f]));
      }
      drawn = has;
    }
    svg += fmt::format("<path class=\"line\"{} d=\"{}\"/>", kLineStyles[k % 2], path);
    if (!lines[k].name.empty()) {
      legend += fmt::format("{}{}{}", legend.empty() ? ": " : ", ", lines[k].name,
                            k % 2 == 1 ? " (dashed)" : "");
    }
  }
  const double step = time_step(duration);
  for (int k = 0; k * step <= duration + 1e-9; ++k) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:g}\" text-anchor=\"middle\">{:g}{}</text>",
                       x_of(k * step), kPlotHeight - 3.0, k * step, k == 0 ? " s" : "");
  }
  svg += fmt::format("<text class=\"name\" x=\"{:g}\" y=\"8\">{}{}{}{}</text></svg>\n", kValueRoom,
                     scale.name, scale.unit.empty() ? "" : ", ", scale.unit, markup_text(legend));
  return svg;
}

}  // namespace shigusa
