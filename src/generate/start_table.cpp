// SPDX-License-Identifier: MIT
#include "generate/start_table.hpp"

#include <algorithm>
#include <shigusa/math.hpp>
#include <string>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "kinematics/forward_kinematics.hpp"

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

constexpr double kPlaceUnit = 1e-3;  // statures

// Dimensions of the tables' bodies, in statures: the shoulder's height and the length from it to
// the hand's point.
using F = StatureFractions;
constexpr double kTableShoulder = F::kShoulderHeight;
constexpr double kTableArm = F::kUpperArm + F::kForearm + kGripFraction * F::kHand;

// The length (m) of the arm along its joints to the hand's point.
double arm_length(const BodyModel& body, const Effector& hand, const Kinematics<double>& start) {
  double length = 0.0;
  Vec3d at = start.origin[index(hand.limb_root)];
  for (const int d : body.chain(hand.link)) {
    if (d <= hand.limb_root) continue;
    length += norm(start.origin[index(d)] - at);
    at = start.origin[index(d)];
  }
  return length + norm(start.point(hand.link, hand.point) - at);
}
constexpr std::string_view kRight = "right_";
constexpr std::string_view kLeft = "left_";

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

double coordinate_of(char digit) {
  return static_cast<double>(kStartDigits.find(digit)) /
         static_cast<double>(kStartDigits.size() - 1);
}

// One column of a table for one hand.
struct Column {
  int gene = -1;          // gene that it sets; -1: none
  bool mirrored = false;  // changes its sign in the mirror
  bool arm = false;       // belongs to the hand's own arm
};

std::vector<Column> columns_of(const StartTable& table, const ParameterSpace& space, bool left) {
  std::vector<Column> columns;
  for (std::string name : words_of(table.names)) {
    Column column{.mirrored = left && name == "twist", .arm = name.starts_with(kRight)};
    if (left && column.arm) name = std::string(kLeft) + name.substr(kRight.size());
    column.gene = space.find(name);
    columns.push_back(std::move(column));
  }
  return columns;
}

// The table with the most columns that the space has, then one with as many feet; none if the space
// has at most half of them.
const StartTable* table_of(const ParameterSpace& space, std::size_t feet, bool left) {
  const StartTable* best = nullptr;
  std::pair<std::size_t, bool> most{};
  for (const StartTable& table : start_tables()) {
    const std::vector<Column> columns = columns_of(table, space, left);
    const auto known = static_cast<std::size_t>(
        std::count_if(columns.begin(), columns.end(), [](const Column& c) { return c.gene >= 0; }));
    const std::pair fits{known, table.feet == feet};
    if (2 * known <= columns.size() || fits <= most) continue;
    most = fits;
    best = &table;
  }
  return best;
}

// The rows nearest to a position (statures), nearest first; ties in the order of the table.
std::vector<const StartRow*> nearest_rows(const StartTable& table, const Vec3d& place, int most) {
  std::vector<std::pair<double, const StartRow*>> rows;
  for (const StartRow& row : table.rows) {
    const Vec3d at{kPlaceUnit * row.place[0], kPlaceUnit * row.place[1], kPlaceUnit * row.place[2]};
    rows.emplace_back(dot(at - place, at - place), &row);
  }
  const auto count = std::min(rows.size(), index(most));
  std::partial_sort(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count), rows.end());
  std::vector<const StartRow*> nearest;
  for (std::size_t k = 0; k < count; ++k) nearest.push_back(rows[k].second);
  return nearest;
}

}  // namespace

std::optional<Vec3d> start_place(const BodyModel& body, const State& home, int effector,
                                 const Vec3d& goal) {
  if (index(effector) >= body.effectors().size() || body.stature() <= 0.0) return std::nullopt;
  const Effector& hand = body.effector(effector);
  if (hand.part.limb != LimbKind::arm || !hand.part.side) return std::nullopt;
  const Kinematics<double> start = placed(body, home);
  const Vec3d shoulder = start.origin[index(hand.limb_root)];
  const double arm = arm_length(body, hand, start);
  if (arm <= 0.0) return std::nullopt;
  Vec3d place = (goal - shoulder) * (kTableArm / arm);
  // below the shoulder, distances scale with the shoulder's height if the floor is beyond the arm's
  // length
  if (place.y < 0.0 && shoulder.y > arm) place.y = (goal.y / shoulder.y - 1.0) * kTableShoulder;
  if (hand.part.side == Side::left) place.x = -place.x;
  return place;
}

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

std::vector<double> nearest_starts(const ReachProblem& problem, const ParameterSpace& space,
                                   int most) {
  const auto genes = index(space.genes());
  std::vector<double> sums;
  std::vector<double> counts(genes, 0.0);
  for (const ReachGoal& goal : problem.goals) {
    const BodyModel& body = *problem.body;
    const std::optional<Vec3d> place =
        start_place(body, problem.rise.empty() ? problem.home : problem.standing(), goal.effector,
                    goal.path.goal);
    if (!place) continue;
    const bool left = body.effector(goal.effector).part.side == Side::left;
    const StartTable* table = table_of(space, body.feet().size(), left);
    if (table == nullptr) continue;
    const std::vector<Column> columns = columns_of(*table, space, left);
    const std::vector<const StartRow*> rows = nearest_rows(*table, *place, most);
    sums.resize(rows.size() * genes, 0.0);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].gene < 0) continue;
      const std::size_t gene = index(columns[c].gene);
      counts[gene] += 1.0;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const double x = coordinate_of(rows[k]->coordinates[c]);
        sums[k * genes + gene] += columns[c].mirrored ? 1.0 - x : x;
      }
    }
  }
  const std::vector<double> plain = space.start();
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const std::size_t gene = k % genes;
    sums[k] = counts[gene] > 0.0 ? sums[k] / counts[gene] : plain[gene];
  }
  return sums;
}

std::vector<double> known_starts(const ReachProblem& problem, const ParameterSpace& space,
                                 std::span<const Parameters> given) {
  std::vector<double> points;
  for (const Parameters& values : given) {
    const std::vector<double> point = space.encode(values);
    points.insert(points.end(), point.begin(), point.end());
  }
  const int left = kNearestStarts - static_cast<int>(given.size());
  const std::vector<double> nearest = nearest_starts(problem, space, std::max(left, 0));
  points.insert(points.end(), nearest.begin(), nearest.end());
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
