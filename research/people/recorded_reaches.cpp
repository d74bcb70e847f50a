// SPDX-License-Identifier: MIT
#include "recorded_reaches.hpp"

#include <algorithm>
#include <cmath>
#include <shigusa/math.hpp>

#include "files/file.hpp"
#include "tab_table.hpp"

namespace shigusa::bench {
namespace {

constexpr std::size_t kTableMaxBytes = 1 << 20;

// Criteria of standing with hanging arms: the wrist at about the height of the hips, the trunk
// upright and the knees nearly straight. A reach goes somewhere in front of the person.
constexpr double kHangsFrom = 0.70;  // m
constexpr double kHangsTo = 1.05;    // m
constexpr double kUpright = 15.0;    // degrees
constexpr double kStraight = 35.0;   // degrees
constexpr double kInFront = 0.10;    // m

bool can_be_set_up(const TabRow& row) {
  const double from = row.number("h0");
  return from >= kHangsFrom && from <= kHangsTo && std::fabs(row.number("tr0")) <= kUpright &&
         row.number("kn0") <= kStraight && row.number("f1") >= kInFront && row.number("dur") > 0.0;
}

RecordedReach reach_of(const TabRow& row) {
  const auto change = [&](const char* from, const char* to) {
    return radians(row.number(to) - row.number(from));
  };
  RecordedReach reach;
  reach.person = row.text("person");
  reach.both = row.text("hand").starts_with("both") ||
               row.text("action").find("both hands") != std::string_view::npos;
  reach.duration = row.number("dur");
  reach.from = row.number("h0");
  reach.height = row.number("h1");
  reach.ahead = row.number("f1");
  reach.figures = {.trunk = change("tr0", "tr1"),
                   .knee = change("kn0", "kn1"),
                   .drop = -row.number("pdy"),
                   .back = -row.number("pfw"),
                   .bow = row.number("bowf") / row.number("D"),
                   .peak = row.number("pf")};
  return reach;
}

}  // namespace

Result<std::vector<RecordedReach>> read_recorded_reaches(const std::filesystem::path& table) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(table, kTableMaxBytes));
  const auto lines = split(text, '\n');
  const auto head = split(lines.front(), '\t');
  SHG_TRY(expect_columns(head,
                         {"person", "action", "hand", "dur", "D", "h0", "h1", "f1", "pdy", "pfw",
                          "bowf", "pf", "tr0", "tr1", "kn0", "kn1"},
                         table));
  std::vector<RecordedReach> reaches;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const TabRow row(head, split(lines[i], '\t'));
    if (can_be_set_up(row)) reaches.push_back(reach_of(row));
  }
  if (reaches.empty()) return fail(ErrorCode::parse, "has no reach to set up", table.string());
  return reaches;
}

}  // namespace shigusa::bench
