// SPDX-License-Identifier: MIT
#include "recorded_curves.hpp"

#include "files/file.hpp"
#include "tab_table.hpp"

namespace shigusa::bench {
namespace {

constexpr std::size_t kTableMaxBytes = 1 << 20;

}  // namespace

Result<std::vector<RecordedCurve>> read_recorded_curves(const std::filesystem::path& table) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(table, kTableMaxBytes));
  const auto lines = split(text, '\n');
  const auto head = split(lines.front(), '\t');
  SHG_TRY(expect_columns(head,
                         {"reach", "duration_s", "share_of_time", "trunk_deg", "knee_deg",
                          "wrist_up_m", "wrist_ahead_m"},
                         table));
  std::vector<RecordedCurve> curves;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    const TabRow row(head, split(lines[i], '\t'));
    const std::string reach(row.text("reach"));
    if (curves.empty() || curves.back().reach != reach) {
      curves.push_back({.reach = reach, .duration = row.number("duration_s")});
    }
    RecordedCurve& curve = curves.back();
    curve.time.push_back(row.number("share_of_time"));
    curve.trunk.push_back(row.number("trunk_deg"));
    curve.knee.push_back(row.number("knee_deg"));
    curve.wrist.push_back({row.number("wrist_ahead_m"), row.number("wrist_up_m")});
  }
  if (curves.empty()) return fail(ErrorCode::parse, "has no reach", table.string());
  return curves;
}

}  // namespace shigusa::bench
