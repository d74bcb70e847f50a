// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Digits of a start table: a coordinate of a ParameterSpace in 1/61 of its range.
inline constexpr std::string_view kStartDigits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
// Place of a digit in kStartDigits; -1 for other characters.
[[nodiscard]] constexpr int start_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'Z') return c - 'A' + 10;
  return c >= 'a' && c <= 'z' ? c - 'a' + 36 : -1;
}

// The kind of task that a start table is for.
struct StartKind {
  bool both = false;    // of both hands; else of one, the right one or its mirror image
  bool sits = false;    // of a body that sits
  bool bent = false;    // begins bent, and stands up
  bool turned = false;  // goals give rotations

  friend bool operator==(const StartKind&, const StartKind&) = default;
};

// The differences of tasks of a kind. Of a single left hand places are those of the mirror image.
struct StartKey {
  std::array<Vec3d, 2> places{};  // statures, of the right hand and the left, see start_place
  std::array<Quatd, 2> turns{};   // R_WL of these hands at the end
  double load = 0.0;              // kg, in all hands
  Vec3d stoop{};                  // statures, from the shoulders in standing to those at the start
};

// A task, and the coordinates of motions to it that look different, the best one first: one digit
// each, in the order of StartTable::names.
struct StartRow {
  StartKey key{};
  std::vector<std::string_view> motions{};
};

// The paper's limb table for a whole body: start points of a search by what is asked. Rows do not
// depend on the body: nearly the same parameters serve other people for positions relative to
// their size.
struct StartTable {
  StartKind kind{};
  std::size_t feet = 0;                   // feet on which its body stands
  std::vector<std::string_view> names{};  // names of the coordinates
  std::vector<StartRow> rows{};
};

// The tables in use: those of data/starts.tsv until others are set. Setting fails, and changes
// nothing, on a text of another form; it must not happen during a search.
[[nodiscard]] std::span<const StartTable> start_tables();
[[nodiscard]] bool set_start_tables(std::string text);
// The contents of data/starts.tsv; empty in a module that gets them as a file of its own.
extern const std::string_view kStartText;
// The text of tables.
[[nodiscard]] std::string start_text(std::span<const StartTable> tables);

// The kind of a problem; none without a goal of a hand.
[[nodiscard]] std::optional<StartKind> start_kind(const ReachProblem& problem);
// The key of a problem with a kind, without rotations.
[[nodiscard]] StartKey start_key(const ReachProblem& problem);
// The goals of a problem's hands, the right one first.
[[nodiscard]] std::vector<const ReachGoal*> goals_of_hands(const ReachProblem& problem);

// Goal position relative to the shoulder of the body at home, in statures; mirrored for a left
// hand. None for effectors other than hands.
[[nodiscard]] std::optional<Vec3d> start_place(const BodyModel& body, const State& home,
                                               int effector, const Vec3d& goal);

// A row of a table, or its mirror image.
struct NearRow {
  double distance2 = 0.0;  // statures², from the problem
  const StartRow* row = nullptr;
  bool mirrored = false;
};
// The rows nearest to a problem of the table's kind or one with more circumstances, nearest first;
// ties in the order of the table.
[[nodiscard]] std::vector<NearRow> nearest_rows(const ReachProblem& problem,
                                                const StartTable& table, int most);

}  // namespace shigusa
