// SPDX-License-Identifier: MIT
#include "generate/start_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

#include "body/anthropometry.hpp"
#include "body/load.hpp"
#include "body/seat.hpp"
#include "core/index.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {
namespace {

// Dimensions of the tables' bodies, in statures: the shoulder's height and the length from it to
// the hand's point.
using F = StatureFractions;
constexpr double kTableShoulder = F::kShoulderHeight;
constexpr double kTableArm = F::kUpperArm + F::kForearm + kGripFraction * F::kHand;

// Places (statures; chosen) that are as far apart as a kilogram of load, and as a radian of turn.
constexpr double kLoadWeight = 0.02;
constexpr double kTurnWeight = 0.1;

// Circumstances of a kind and their words.
struct Circumstance {
  bool StartKind::*is;
  std::string_view word;
};
constexpr std::string_view kOne = "one";  // of a kind without any
constexpr Circumstance kCircumstances[] = {{&StartKind::both, "both"},
                                           {&StartKind::sits, "sits"},
                                           {&StartKind::bent, "bent"},
                                           {&StartKind::turned, "turned"}};

// Calls `each` with each number of a key of a kind, and its unit in a table's file.
template <class Key, class Each>
void for_numbers(const StartKind& kind, Key& key, const Each& each) {
  constexpr double kThousandth = 1e-3;
  for (std::size_t hand = 0; hand < (kind.both ? 2U : 1U); ++hand) {
    for (int k = 0; k < 3; ++k) each(key.places[hand][k], kThousandth);
    if (!kind.turned) continue;
    auto& turn = key.turns[hand];
    for (auto* part : {&turn.x, &turn.y, &turn.z, &turn.w}) each(*part, kThousandth);
  }
  each(key.load, 0.1);
  for (int k = 0; kind.bent && k < 3; ++k) each(key.stoop[k], kThousandth);
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

// Reads tables: a line `table WORDS FEET COORDINATES…` and its rows `KEY MOTION…`, with tabs
// between cells and spaces within them; lines that begin with # are remarks.
class TableReader {
 public:
  // The tables, which refer to the text; none if it has not their form.
  std::optional<std::vector<StartTable>> read(std::string_view text) {
    for (const std::string_view line : parts_of(text, '\n')) {
      if (line.empty() || line.starts_with('#')) continue;
      const std::vector<std::string_view> cells = parts_of(line, '\t');
      const bool good = cells.front() == "table" ? begin(cells) : add(cells);
      if (!good) return std::nullopt;
    }
    return std::move(tables_);
  }

 private:
  bool begin(const std::vector<std::string_view>& cells) {
    if (cells.size() != 4) return false;
    StartTable& table = tables_.emplace_back();
    const std::vector<std::string_view> words = parts_of(cells[1], ' ');
    std::ptrdiff_t known = std::count(words.begin(), words.end(), kOne);
    for (const auto& [is, word] : kCircumstances) {
      table.kind.*is = std::find(words.begin(), words.end(), word) != words.end();
      known += table.kind.*is ? 1 : 0;
    }
    if (known != static_cast<std::ptrdiff_t>(words.size())) return false;
    table.names = parts_of(cells[3], ' ');
    table.feet = cells[2] == "1" ? 1 : 2;
    return (cells[2] == "1" || cells[2] == "2") && !table.names.empty();
  }

  bool add(const std::vector<std::string_view>& cells) {
    if (tables_.empty() || cells.size() < 2) return false;
    StartTable& table = tables_.back();
    StartRow& row = table.rows.emplace_back();
    const char* at = cells.front().data();
    const char* const end = at + cells.front().size();
    bool good = true;
    for_numbers(table.kind, row.key, [&](double& number, double unit) {
      int value = 0;
      const auto [after, error] = std::from_chars(at, end, value);
      good = good && error == std::errc{};
      number = unit * value;
      at = after < end && *after == ' ' ? after + 1 : after;
    });
    row.motions.assign(cells.begin() + 1, cells.end());
    for (const std::string_view digits : row.motions) {
      good = good && digits.size() == table.names.size() &&
             std::all_of(digits.begin(), digits.end(), [](char c) { return start_digit(c) >= 0; });
    }
    return good && at == end;
  }

  std::vector<StartTable> tables_{};
};

// Tables with the text that they refer to, where it is not kStartText.
struct Tables {
  std::unique_ptr<const std::string> text{};
  std::vector<StartTable> tables{};
};
Tables& tables_in_use() {
  static Tables used{.tables = TableReader().read(kStartText).value()};
  return used;
}

Vec3d mirrored(const Vec3d& place) { return {-place.x, place.y, place.z}; }
Quatd mirrored(const Quatd& turn) { return {turn.x, -turn.y, -turn.z, turn.w}; }

bool is_left(const ReachProblem& problem, const ReachGoal& hand) {
  return problem.body->effector(hand.effector).part.side == Side::left;
}

// The key of a row's mirror image: two hands are exchanged; places of one hand are told as if it
// were the right one.
StartKey mirrored(const StartKind& kind, const StartKey& key) {
  StartKey image = key;
  for (Quatd& turn : image.turns) turn = mirrored(turn);
  if (!kind.both) return image;
  image.places = {mirrored(key.places[1]), mirrored(key.places[0])};
  std::swap(image.turns[0], image.turns[1]);
  image.stoop = mirrored(key.stoop);
  return image;
}

double squared(const Vec3d& v) { return dot(v, v); }

// Squared distance (statures²) of a row from a problem with a key.
double distance2(std::span<const ReachGoal* const> hands, const StartKey& key,
                 const StartKind& kind, const StartKey& row) {
  const double load = kLoadWeight * (key.load - row.load);
  double sum = load * load;
  if (kind.bent) sum += squared(key.stoop - row.stoop);
  for (std::size_t hand = 0; hand < hands.size(); ++hand) {
    sum += squared(key.places[hand] - row.places[hand]);
    if (!kind.turned) continue;
    const double turn = kTurnWeight * hands[hand]->turn.miss(to_matrix(row.turns[hand]));
    sum += turn * turn;
  }
  return sum;
}

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

// Middle (m) between the shoulders of hands with goals.
Vec3d shoulders_at(const ReachProblem& problem, const State& state) {
  const Kinematics<double> at = placed(*problem.body, state);
  const std::vector<const ReachGoal*> hands = goals_of_hands(problem);
  Vec3d sum{};
  for (const ReachGoal* hand : hands) {
    sum = sum + at.origin[index(problem.body->effector(hand->effector).limb_root)];
  }
  return sum * (1.0 / static_cast<double>(hands.size()));
}

}  // namespace

std::span<const StartTable> start_tables() { return tables_in_use().tables; }

bool set_start_tables(std::string text) {
  auto kept = std::make_unique<const std::string>(std::move(text));
  auto tables = TableReader().read(*kept);
  if (!tables) return false;
  tables_in_use() = {std::move(kept), std::move(*tables)};
  return true;
}

std::string start_text(std::span<const StartTable> tables) {
  std::string text;
  for (const StartTable& table : tables) {
    text += "table\t";
    for (const auto& [is, word] : kCircumstances) {
      if (table.kind.*is) text.append(word).append(" ");
    }
    if (text.back() == ' ') text.pop_back();
    if (table.kind == StartKind{}) text += kOne;
    text += fmt::format("\t{}\t{}\n", table.feet, fmt::join(table.names, " "));
    for (const StartRow& row : table.rows) {
      std::string key;
      for_numbers(table.kind, row.key, [&key](double number, double unit) {
        key += fmt::format("{}{}", key.empty() ? "" : " ", std::lround(number / unit));
      });
      text += fmt::format("{}\t{}\n", key, fmt::join(row.motions, "\t"));
    }
  }
  return text;
}

std::vector<const ReachGoal*> goals_of_hands(const ReachProblem& problem) {
  std::vector<const ReachGoal*> hands;
  for (const Side side : {Side::right, Side::left}) {
    for (std::size_t g = 0; g < problem.asked() && hands.size() < 2; ++g) {
      const ReachGoal& goal = problem.goals[g];
      const BodyModel& body = *problem.body;
      if (index(goal.effector) >= body.effectors().size() || body.stature() <= 0.0) continue;
      const JointPlace& part = body.effector(goal.effector).part;
      if (part.limb == LimbKind::arm && part.side == side) hands.push_back(&goal);
    }
  }
  return hands;
}

std::optional<StartKind> start_kind(const ReachProblem& problem) {
  const std::vector<const ReachGoal*> hands = goals_of_hands(problem);
  if (hands.empty()) return std::nullopt;
  const auto is_turned = [](const ReachGoal* hand) { return hand->turn.kind != Turning::free; };
  return StartKind{.both = hands.size() == 2,
                   .sits = sits(*problem.body),
                   .bent = !problem.rise.empty(),
                   .turned = std::any_of(hands.begin(), hands.end(), is_turned)};
}

StartKey start_key(const ReachProblem& problem) {
  const State upright = problem.rise.empty() ? problem.home : problem.standing();
  const std::vector<const ReachGoal*> hands = goals_of_hands(problem);
  const bool one_left = hands.size() == 1 && is_left(problem, *hands.front());
  StartKey key;
  for (std::size_t hand = 0; hand < hands.size(); ++hand) {
    const ReachGoal& goal = *hands[hand];
    const Vec3d place = start_place(*problem.body, upright, goal.effector, goal.path.goal).value();
    key.places[hand] = hand == 1 ? mirrored(place) : place;
    for (const HeldLoad& held : problem.start().held) {
      if (held.effector == goal.effector) key.load += held.mass;
    }
  }
  if (problem.rise.empty()) return key;
  const Vec3d stoop = shoulders_at(problem, problem.start()) - shoulders_at(problem, upright);
  key.stoop = (one_left ? mirrored(stoop) : stoop) * (1.0 / problem.body->stature());
  return key;
}

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

std::vector<NearRow> nearest_rows(const ReachProblem& problem, const StartTable& table, int most) {
  const std::vector<const ReachGoal*> hands = goals_of_hands(problem);
  const StartKey key = start_key(problem);
  const bool left = is_left(problem, *hands.front());
  std::vector<NearRow> rows;
  const auto add = [&](const StartRow& row, const StartKey& as, bool image) {
    rows.push_back({distance2(hands, key, table.kind, as), &row, image});
  };
  for (const StartRow& row : table.rows) {
    if (!left) add(row, row.key, false);
    if (left || table.kind.both) add(row, mirrored(table.kind, row.key), true);
  }
  const auto count = std::min(rows.size(), index(std::max(most, 0)));
  std::partial_sort(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count), rows.end(),
                    [](const NearRow& a, const NearRow& b) {
                      return std::tuple(a.distance2, a.row, a.mirrored) <
                             std::tuple(b.distance2, b.row, b.mirrored);
                    });
  rows.resize(count);
  return rows;
}

}  // namespace shigusa
