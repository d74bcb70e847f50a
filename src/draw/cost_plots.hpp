// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// A band of a scale, up to a value, in a colour of the page's style sheet.
struct ScaleBand {
  double most;
  std::string_view colour;
};
// A scale from 0 with its bands, as the method has them; values beyond the last band are drawn at
// its end.
struct CostScale {
  std::string_view name;
  std::string_view unit;
  std::span<const ScaleBand> bands;
};

// Scales of REBA's and RULA's scores, of compression (kN) and moment (N·m) at L5/S1, and of the
// lifting index. Bands of the moment: E. Tichauer (1978), as a rating of the DGUV quotes them.
extern const CostScale kRebaScale;
extern const CostScale kRulaScale;
extern const CostScale kCompressionScale;
extern const CostScale kMomentScale;
extern const CostScale kLiftScale;

// The colour of a value.
[[nodiscard]] std::string_view colour_of(const CostScale& scale, double value);

// A table row: the scale's name, its bands as a bar with a mark at the value, and the value.
[[nodiscard]] std::string bar_row(const CostScale& scale, double value, std::string_view about);

// A line of a plot; empty values break it.
struct PlotLine {
  std::string_view name;
  std::vector<std::optional<double>> values;
};
// A plot (SVG) of lines over time (s, the duration of the whole), on the scale's bands, with marks
// where parts of the motion begin.
[[nodiscard]] std::string plot_over_time(const CostScale& scale, std::span<const PlotLine> lines,
                                         double duration, std::span<const double> begins);

}  // namespace shigusa
