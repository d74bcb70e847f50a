// SPDX-License-Identifier: MIT
#include "generate/known_starts.hpp"

#include <algorithm>
#include <string>
#include <tuple>

#include "core/index.hpp"
#include "generate/start_table.hpp"

namespace shigusa {
namespace {

// Bent postures (deg): leans of the trunk and bends of the knees, and the lower bounds of both
// modes for a standing body.
constexpr double kLeans[] = {0.0, 30.0, 60.0, 90.0};
constexpr double kSquats[] = {0.0, 40.0, 80.0, 120.0};
// Bends of the knees (deg; chosen, four batches) tried for a habit, in the nearest rows of the
// table.
constexpr double kHabitSquats[] = {10.0, 40.0, 65.0, 85.0, 100.0, 115.0, 130.0, 138.0};
constexpr int kHabitRows = 8;
// Rows in which motions of a part of the space are looked for, and the rounding of a digit.
constexpr int kRowsWithin = 48;
constexpr double kDigit = 1.0 / 61.0;

constexpr std::string_view kRight = "right_";
constexpr std::string_view kLeft = "left_";

double coordinate_of(char digit) {
  return start_digit(digit) / static_cast<double>(kStartDigits.size() - 1);
}

// Number of circumstances of a kind.
int circumstances(const StartKind& kind) { return kind.sits + kind.bent + kind.turned; }

bool is_within(std::span<const double> point, const Niche& niche) {
  return std::all_of(niche.begin(), niche.end(), [point](const Bound& bound) {
    const double x = point[index(bound.gene)];
    return x >= bound.low - kDigit && x <= bound.high + kDigit;
  });
}

}  // namespace

std::vector<double> bent_starts(const ParameterSpace& space) {
  std::vector<double> points;
  const auto set = [&](std::string_view mode, double value) {
    const int gene = space.find(mode);
    if (gene < 0) return;
    *(points.end() - space.genes() + gene) = space.coordinate(gene, radians(value));
  };
  const std::vector<double> upright = space.start();
  for (const double squat : kSquats) {
    for (const double lean : kLeans) {
      points.insert(points.end(), upright.begin(), upright.end());
      set("squat", squat);
      set("lean", lean);
    }
  }
  return points;
}

std::vector<double> habit_starts(const ReachProblem& problem, const ParameterSpace& space,
                                 std::span<const double> known) {
  const int squat = space.find("squat");
  if (squat < 0 || problem.context.habit.knees == Habit{}.knees) return {};
  std::vector<double> points;
  const std::size_t genes = index(space.genes());
  const std::size_t rows = std::min(known.size() / genes, index(kHabitRows));
  for (std::size_t k = 0; k < rows; ++k) {
    for (const double bent : kHabitSquats) {
      const auto row = known.subspan(k * genes, genes);
      points.insert(points.end(), row.begin(), row.end());
      *(points.end() - space.genes() + squat) = space.coordinate(squat, radians(bent));
    }
  }
  return points;
}

std::vector<KnownStarts::Column> KnownStarts::columns_of(const StartTable& table,
                                                         const ParameterSpace& space, bool mirror) {
  std::vector<Column> columns;
  for (const std::string_view known : table.names) {
    std::string name(known);
    if (mirror && known.starts_with(kRight)) name = kLeft;
    if (mirror && known.starts_with(kLeft)) name = kRight;
    if (name != known) name += known.substr(known.find('_') + 1);
    columns.push_back({.gene = space.find(name), .mirrored = mirror && name == "twist"});
  }
  return columns;
}

// The table for a problem; none if no goal is a hand's, or the space has at most half of a table's
// columns.
const StartTable* KnownStarts::table_for(const ReachProblem& problem) const {
  const std::optional<StartKind> kind = start_kind(problem);
  if (!kind) return nullptr;
  const bool left =
      problem.body->effector(goals_of_hands(problem).front()->effector).part.side == Side::left;
  const StartTable* best = nullptr;
  std::tuple<int, std::size_t, bool> most{};
  for (const StartTable& table : start_tables()) {
    const StartKind& has = table.kind;
    const bool less =
        has.sits <= kind->sits && has.bent <= kind->bent && has.turned <= kind->turned;
    if (has.both != kind->both || !less) continue;
    const std::vector<Column> columns = columns_of(table, space_, left);
    const auto known = static_cast<std::size_t>(
        std::count_if(columns.begin(), columns.end(), [](const Column& c) { return c.gene >= 0; }));
    const std::tuple fits{circumstances(has), known, table.feet == problem.body->feet().size()};
    if (2 * known <= columns.size() || fits <= most) continue;
    most = fits;
    best = &table;
  }
  return best;
}

KnownStarts::KnownStarts(const ReachProblem& problem, const ParameterSpace& space) : space_(space) {
  const StartTable* table = table_for(problem);
  if (table == nullptr) return;
  columns_ = {columns_of(*table, space_, false), columns_of(*table, space_, true)};
  rows_ = nearest_rows(problem, *table, kRowsWithin);
}

void KnownStarts::add(const NearRow& row, std::string_view digits,
                      std::vector<double>& points) const {
  const std::vector<double> plain = space_.start();
  points.insert(points.end(), plain.begin(), plain.end());
  const auto point = points.end() - space_.genes();
  const std::vector<Column>& columns = columns_[row.mirrored ? 1 : 0];
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].gene < 0) continue;
    const double x = coordinate_of(digits[c]);
    point[columns[c].gene] = columns[c].mirrored ? 1.0 - x : x;
  }
}

std::vector<double> KnownStarts::points(std::span<const Parameters> given) const {
  std::vector<double> points;
  for (const Parameters& values : given) {
    const std::vector<double> point = space_.encode(values);
    points.insert(points.end(), point.begin(), point.end());
  }
  const std::size_t most = index(kNearestStarts) - std::min(given.size(), index(kNearestStarts));
  for (std::size_t k = 0; k < std::min(most, rows_.size()); ++k) {
    add(rows_[k], rows_[k].row->motions.front(), points);
  }
  return points;
}

std::vector<double> KnownStarts::within(const Niche& niche) const {
  std::vector<double> points;
  const std::size_t genes = index(space_.genes());
  for (const NearRow& row : rows_) {
    for (const std::string_view digits : row.row->motions) {
      if (points.size() >= genes * index(kNearestStarts)) return points;
      add(row, digits, points);
      if (!is_within(std::span(points).last(genes), niche)) points.resize(points.size() - genes);
    }
  }
  return points;
}

std::vector<double> start_scales(std::span<const double> points, int genes) {
  const std::size_t n = index(genes);
  const std::size_t count = points.size() / n;
  if (count < 2) return {};
  std::vector<double> scales(n, 0.0);  // variances first
  double sum = 0.0;
  for (std::size_t g = 0; g < n; ++g) {
    double mean = 0.0;
    for (std::size_t k = 0; k < count; ++k) mean += points[k * n + g];
    mean /= static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double off = points[k * n + g] - mean;
      scales[g] += off * off;
    }
    sum += scales[g];
  }
  if (!(sum > 0.0)) return {};
  const double mean = sum / static_cast<double>(n);
  for (double& scale : scales) scale = max(sqrt(scale / mean), kLeastScale);
  return scales;
}

}  // namespace shigusa
