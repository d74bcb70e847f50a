// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <set>

#include "formats/xml.hpp"
#include "show_page.hpp"
#include "show_plot.hpp"

namespace shigusa {
namespace {

constexpr double kTwoThirds = 2.0 / 3.0;  // of a bin's place for its bar, at least

struct OutcomeLook {
  Outcome outcome;
  MarkShape shape;
  std::string_view style;
  std::string_view sign;
  std::string_view says;
};
constexpr std::array kLooks{
    OutcomeLook{Outcome::reached, MarkShape::dot, "c1", "\u25CF", "reached"},
    OutcomeLook{Outcome::unsteady, MarkShape::triangle, "c2", "\u25B2",
                "reached by impossible motions only"},
    OutcomeLook{Outcome::unreachable, MarkShape::cross, "c3", "\u2715", "missed"},
};

// One of the three views of the goals.
struct ReachView {
  std::string_view title;
  std::string_view x_name;
  std::string_view y_name;
  Vec3d right;
  Vec3d up;
  bool down;  // y grows downwards
};

struct Range {
  double low = 1e9;
  double high = -1e9;
  void add(double value) {
    low = min(low, value);
    high = max(high, value);
  }
};

// Frame with the same scale on both axes.
PlotFrame even_frame(Range across, Range up, bool down) {
  constexpr double kWidth = 300.0;
  constexpr double kHeight = 330.0;
  constexpr double kAir = 0.08;  // m
  across = {across.low - kAir, across.high + kAir};
  up = {up.low - kAir, up.high + kAir};
  const double scale = min(kWidth / (across.high - across.low), kHeight / (up.high - up.low));
  const double wider = 0.5 * (kWidth / scale - (across.high - across.low));
  return {.width = kWidth,
          .height = scale * (up.high - up.low),
          .low_x = across.low - wider,
          .high_x = across.high + wider,
          .low_y = up.low,
          .high_y = up.high,
          .down = down};
}

std::string reach_view(const ReachView& view, const std::vector<GoalMark>& goals,
                       const SheetMotion* person) {
  Range across;
  Range up;
  for (const GoalMark& goal : goals) {
    across.add(dot(goal.place, view.right));
    up.add(dot(goal.place, view.up));
  }
  if (person != nullptr) {
    for (std::size_t n = 0; n < person->places.names.size(); ++n) {
      across.add(dot(person->places.at(0, static_cast<int>(n)), view.right));
      up.add(dot(person->places.at(0, static_cast<int>(n)), view.up));
    }
  }
  const PlotFrame frame = even_frame(across, up, view.down);
  std::string body = axes(frame, view.x_name, view.y_name);
  if (person != nullptr) {
    const double scale = frame.width / (frame.high_x - frame.low_x) / 100.0;
    body += fmt::format(
        R"svg(<g transform="translate({:.2f} {:.2f}) scale({:.4f})">{}</g>)svg", frame.x(0.0),
        frame.y(0.0), scale,
        figure_svg(person->places, 0, {view.right, view.down ? -view.up : view.up}, "scale"));
  }
  for (const OutcomeLook& look : kLooks) {
    Marks marks(look.shape);
    for (const GoalMark& goal : goals) {
      if (goal.outcome != look.outcome) continue;
      marks.add(frame.x(dot(goal.place, view.right)), frame.y(dot(goal.place, view.up)));
    }
    body += marks.svg(look.style);
  }
  return figure({.title = std::string(view.title),
                 .caption = "",
                 .says = fmt::format("Goals, {}: {} over {}", view.title, view.y_name, view.x_name),
                 .height = frame.top + frame.height + 40.0,
                 .body = body});
}

// Quantile of the scores.
double quantile(const std::vector<std::uint64_t>& bins, double share) {
  const auto all = static_cast<double>(std::accumulate(bins.begin(), bins.end(), std::uint64_t{0}));
  double below = 0.0;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    below += static_cast<double>(bins[b]);
    if (below >= share * all) return ScoreCounts::kStep * static_cast<double>(b + 1);
  }
  return ScoreCounts::kStep * static_cast<double>(bins.size());
}

// A few dozen bars from the fine counts: width of a bar, and end of the last one.
struct Bars {
  std::size_t bins = 1;  // fine ones in each
  std::size_t first = 0;
  std::size_t count = 0;
};
Bars bars_of(const ScoreCounts& scores) {
  std::vector<std::uint64_t> all(ScoreCounts::kBins, 0);
  for (const auto& bins : scores.bins) {
    for (std::size_t b = 0; b < all.size(); ++b) all[b] += bins[b];
  }
  const auto last =
      static_cast<std::size_t>(nearest_integer(quantile(all, 0.995) / ScoreCounts::kStep));
  const auto begin = std::find_if(all.begin(), all.end(), [](std::uint64_t n) { return n > 0; });
  Bars bars;
  for (const std::size_t width : {1U, 2U, 5U, 10U, 20U, 50U, 100U}) {
    bars.bins = width;
    bars.first = static_cast<std::size_t>(begin - all.begin()) / width;
    bars.count = last / width + 1 - std::min(last / width, bars.first);
    if (bars.count <= 40) break;
  }
  return bars;
}

// Bars of one verdict, with their own scale.
std::string score_row(const std::vector<std::uint64_t>& bins, const Bars& bars, double top,
                      std::size_t verdict) {
  constexpr double kHeight = 62.0;
  constexpr std::array kStyles{"c4", "c5", "c6"};
  constexpr std::array kSigns{"\u25CF", "\u25B2", "\u2715"};
  const double low = ScoreCounts::kStep * static_cast<double>(bars.first * bars.bins);
  const double high =
      ScoreCounts::kStep * static_cast<double>((bars.first + bars.count) * bars.bins);
  const PlotFrame frame{
      .left = 24.0, .top = top, .width = 320.0, .height = kHeight, .low_x = low, .high_x = high};
  std::vector<std::uint64_t> counts(bars.count, 0);
  for (std::size_t b = bars.first * bars.bins; b < bins.size(); ++b) {
    const std::size_t bar = std::min(b / bars.bins - bars.first, bars.count - 1);
    counts[bar] += bins[b];
  }
  const std::uint64_t most =
      std::max<std::uint64_t>(1, *std::max_element(counts.begin(), counts.end()));
  const std::uint64_t all = std::accumulate(bins.begin(), bins.end(), std::uint64_t{0});
  std::string svg = fmt::format(
      R"(<text x="24" y="{:.1f}" class="row"><tspan class="{}">{}</tspan> {}: {}</text>)",
      top - 9.0, kStyles[verdict], kSigns[verdict], word_of(static_cast<Verdict>(verdict)),
      grouped(all));
  svg += fmt::format(R"(<path class="grid" d="M24 {:.1f}H344"/>)", top + kHeight);
  if (all == 0) return svg;
  const double step = frame.width / static_cast<double>(bars.count);
  const double wide = max(kTwoThirds * step, step - 1.5);
  std::string path;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] == 0) continue;
    const double high_bar =
        max(1.5, kHeight * static_cast<double>(counts[k]) / static_cast<double>(most));
    path += fmt::format("M{:.1f} {:.1f}v{:.1f}h{:.1f}v{:.1f}z",
                        frame.left + step * static_cast<double>(k), top + kHeight, -high_bar, wide,
                        high_bar);
  }
  svg += fmt::format(R"(<path class="bars {}" d="{}"/>)", kStyles[verdict], path);
  const double median = quantile(bins, 0.5) - 0.5 * ScoreCounts::kStep;
  const double x = clamp(frame.x(median), frame.left, frame.left + frame.width);
  const bool right = x > 250.0;
  svg += fmt::format(
      R"(<path class="median" d="M{0:.1f} {1:.1f}V{2:.1f}"/><text x="{3:.1f}" y="{4:.1f}" class="{5}">median {6:.2f}</text>)",
      x, top - 2.0, top + kHeight, right ? x - 5.0 : x + 5.0, top + 8.0,
      right ? "end halo" : "halo", median);
  return svg;
}

// Grid of styles, with coarser cells if motions are few.
struct StyleGrid {
  int rows_each = 1;     // of the fine cells in one
  int columns_each = 1;  // the same
  int low = 0;           // row
  int rows = 1;
  int columns = 1;
  StyleCells cells{};
};
StyleGrid grid_of(const StyleCells& fine) {
  constexpr int kRows = 10;
  constexpr int kColumns = 5;  // that have room for their words
  StyleGrid grid;
  const auto floor_of = [](int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); };
  int low = 1 << 20;
  int high = -(1 << 20);
  int away = 0;
  for (const auto& [cell, styles] : fine) {
    low = std::min(low, cell.first);
    high = std::max(high, cell.first);
    away = std::max(away, cell.second);
  }
  while (floor_of(high, grid.rows_each) - floor_of(low, grid.rows_each) >= kRows) {
    grid.rows_each *= 2;
  }
  while (away / grid.columns_each >= kColumns) grid.columns_each *= 2;
  grid.low = floor_of(low, grid.rows_each);
  grid.rows = floor_of(high, grid.rows_each) - grid.low + 1;
  grid.columns = away / grid.columns_each + 1;
  for (const auto& [cell, styles] : fine) {
    auto& into =
        grid.cells[{floor_of(cell.first, grid.rows_each), cell.second / grid.columns_each}];
    for (const auto& [style, count] : styles) into[style] += count;
  }
  return grid;
}

// CSS class of a style; known styles have their own.
std::string_view style_class(PostureWord style) {
  if (style == PostureWord::upright) return "s1";
  if (style == PostureWord::half_squat) return "s2";
  if (style == PostureWord::squat) return "s3";
  return style == PostureWord::stoop ? "s4" : "s5";
}

// A cell: its most frequent style with its count, and a bar of the shares of all styles.
std::string style_cell(const std::map<PostureWord, std::uint64_t>& styles, double x, double y,
                       double width, double height) {
  std::uint64_t all = 0;
  const auto most =
      std::max_element(styles.begin(), styles.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  for (const auto& [style, count] : styles) all += count;
  std::string svg =
      fmt::format(R"(<rect class="cell {}" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)",
                  style_class(most->first), x + 1.0, y + 1.0, width - 2.0, height - 2.0);
  svg += fmt::format(
      R"(<text x="{0:.1f}" y="{1:.1f}" class="mid style">{2}</text><text x="{0:.1f}" y="{3:.1f}" class="mid count">{4}</text>)",
      x + width / 2.0, y + height / 2.0 - 4.0, word_of(most->first), y + height / 2.0 + 8.0,
      styles.size() > 1 ? fmt::format("{} of {}", grouped(most->second), grouped(all))
                        : grouped(all));
  double at = x + 1.0;
  for (const auto& [style, count] : styles) {
    const double share = (width - 2.0) * static_cast<double>(count) / static_cast<double>(all);
    svg +=
        fmt::format(R"(<rect class="share {}" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="4"/>)",
                    style_class(style), at, y + height - 5.0, share);
    at += share;
  }
  return svg;
}

}  // namespace

std::string reach_html(const ShowFacts& facts, const SheetMotion* person) {
  const std::vector<GoalMark> goals = facts.goals.drawn();
  if (goals.empty()) return "<p>No task has a goal.</p>\n";
  std::array<std::uint64_t, kOutcomes> counts{};
  for (const GoalMark& goal : goals) ++counts[static_cast<std::size_t>(goal.outcome)];
  std::string legend;
  for (const OutcomeLook& look : kLooks) {
    legend +=
        fmt::format("<span><b class=\"{}\">{}</b> {}, {} tasks</span>\n", look.style, look.sign,
                    look.says, grouped(facts.tasks[static_cast<std::size_t>(look.outcome)]));
  }
  std::string text = fmt::format("<p class=\"legend\">{}</p>\n", legend);
  if (facts.goals.seen() > goals.size()) {
    text += fmt::format("<p>{} of {} goals, drawn by lot.</p>\n", grouped(goals.size()),
                        grouped(facts.goals.seen()));
  }
  const ReachView views[] = {
      {"From the front", "to the body's left (m)", "height (m)", {1, 0, 0}, {0, 1, 0}, false},
      {"From the side", "ahead (m)", "height (m)", {0, 0, 1}, {0, 1, 0}, false},
      {"From above", "to the body's left (m)", "ahead (m)", {1, 0, 0}, {0, 0, 1}, true},
  };
  text += "<div class=\"plots\">\n";
  for (const ReachView& view : views) text += reach_view(view, goals, person);
  return text + "</div>\n";
}

std::string scores_html(const ShowFacts& facts) {
  if (facts.motion_count() == 0) return {};
  const Bars bars = bars_of(facts.scores);
  std::string body;
  for (std::size_t v = 0; v < kVerdicts; ++v) {
    body += score_row(facts.scores.bins[v], bars, 28.0 + 92.0 * static_cast<double>(v), v);
  }
  const double low = ScoreCounts::kStep * static_cast<double>(bars.first * bars.bins);
  const double high =
      ScoreCounts::kStep * static_cast<double>((bars.first + bars.count) * bars.bins);
  const PlotFrame frame{
      .left = 24.0, .top = 28.0, .width = 320.0, .height = 246.0, .low_x = low, .high_x = high};
  const Ticks across = ticks(low, high, 8);
  for (const double value : across.at) {
    body += fmt::format(R"(<text x="{:.1f}" y="291" class="mid">{}</text>)", frame.x(value),
                        tick_label(value, across.step));
  }
  body += R"(<text x="184" y="308" class="mid name">score (less is better)</text>)";
  return figure({.title = "Scores by verdict",
                 .caption = "Motions of each score. Each verdict has a scale of its own; the last "
                            "bar has all that is more.",
                 .says = "Histograms of the scores of possible, straining and impossible motions",
                 .height = 316.0,
                 .body = body});
}

std::string styles_html(const ShowFacts& facts) {
  if (facts.styles.empty()) return {};
  const StyleGrid grid = grid_of(facts.styles);
  // few rows are higher, so that the axis has room for its name
  const double high = clamp(190.0 / grid.rows, 34.0, 60.0);
  const double wide = 304.0 / static_cast<double>(grid.columns);
  const double left = 46.0;
  const double bottom = 6.0 + high * grid.rows;
  std::string body;
  std::set<PostureWord> known;
  for (const auto& [cell, styles] : grid.cells) {
    const double y = bottom - high * static_cast<double>(cell.first - grid.low + 1);
    body += style_cell(styles, left + wide * cell.second, y, wide, high);
    for (const auto& [style, count] : styles) known.insert(style);
  }
  for (int r = 0; r <= grid.rows; ++r) {
    body += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" class="end">{:.2f}</text>)", left - 5.0,
                        bottom - high * r + 4.0, kCellHeight * (grid.low + r) * grid.rows_each);
  }
  for (int c = 0; c <= grid.columns; ++c) {
    body += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" class="mid">{:.1f}</text>)", left + wide * c,
                        bottom + 14.0, kCellAway * c * grid.columns_each);
  }
  body +=
      fmt::format(R"(<text x="198" y="{:.1f}" class="mid name">distance from the body (m)</text>)",
                  bottom + 31.0);
  body += fmt::format(
      R"svg(<text transform="translate(10 {:.1f}) rotate(-90)" class="mid name">height of the goal (m)</text>)svg",
      bottom / 2.0 + 3.0);
  std::string legend;
  for (const PostureWord style : known) {
    legend += fmt::format("<span><b class=\"{}\">\u25A0</b> {}</span> ", style_class(style),
                          word_of(style));
  }
  return figure(
      {.title = "Styles by height and distance",
       .caption = "The style of each reached task's best motion: the most frequent one of "
                  "the cell, how many have it, and below the shares of all. " +
                  fmt::format("<span class=\"legend\">{}</span>", legend),
       .says = "The most frequent style of motion for goals of each height and distance",
       .height = bottom + 40.0,
       .body = body});
}

std::string people_html(const ShowFacts& facts) {
  const std::vector<PersonMark> people = facts.people.drawn();
  if (people.empty()) return {};
  Range across;
  Range up;
  Marks men(MarkShape::dot);
  Marks women(MarkShape::triangle);
  for (const PersonMark& person : people) {
    across.add(person.stature);
    up.add(person.mass);
  }
  const PlotFrame frame{.height = 246.0,
                        .low_x = across.low - 0.03,
                        .high_x = across.high + 0.03,
                        .low_y = up.low - 3.0,
                        .high_y = up.high + 3.0};
  for (const PersonMark& person : people) {
    (person.female ? women : men).add(frame.x(person.stature), frame.y(person.mass));
  }
  std::string caption = "<span class=\"legend\">";
  if (!women.empty()) caption += "<span><b class=\"c2\">\u25B2</b> female</span> ";
  if (!men.empty()) caption += "<span><b class=\"c1\">\u25CF</b> male</span>";
  caption += "</span> A mark is a task's body.";
  if (facts.people.seen() > people.size()) {
    caption += fmt::format(" {} of {} tasks, drawn by lot.", grouped(people.size()),
                           grouped(facts.people.seen()));
  }
  return figure(
      {.title = "Statures and masses",
       .caption = caption,
       .says = "Mass over stature of the people",
       .height = 296.0,
       .body = axes(frame, "stature (m)", "mass (kg)") + men.svg("c1") + women.svg("c2")});
}

}  // namespace shigusa
