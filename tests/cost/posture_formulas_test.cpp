// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/ergonomics.hpp>

#include "support/ergonomics_rows.hpp"

// REBA, RULA and the zones of EN 1005-4 against the rows of shared/ergonomics, whose sources its
// README names.
namespace shigusa {
namespace {

using testing_support::drawn;
using testing_support::kFormulaCases;
using testing_support::TsvRow;

// Thresholds of the methods' own words, which give neutral no width.
PostureThresholds without_widths() {
  return {.upright = 0.0, .straight_wrist = 0.0, .neck_extends = 0.0};
}

TEST(PostureFormulas, BaseScoresOfAnglesAgree) {
  SHG_ROWS(rows, "angle_rows.tsv", 80);
  for (const TsvRow& row : rows) {
    std::string part = row.text("part");
    std::replace(part.begin(), part.end(), ' ', '_');
    EXPECT_EQ(base_score(value_of<PostureMethod>(row.text("method"), "method").value(),
                         value_of<PosturePart>(part, "part").value(),
                         radians(row.number("angle_deg")), without_widths()),
              row.whole("base_score"))
        << row.text("method") << ' ' << part << ' ' << row.text("angle_deg");
  }
}

// Cells of the tables, read from scores whose other parts leave them unchanged.
TEST(PostureFormulas, TablesOfRebaAgree) {
  SHG_ROWS(rows, "reba_tables.tsv", 240);
  for (const TsvRow& row : rows) {
    const int a = row.whole("k1");
    const int b = row.whole("k2");
    const int value = row.whole("value");
    if (row.text("table") == "A") {
      EXPECT_EQ(reba_score({.neck = a, .trunk = b, .legs = row.whole("k3")}).table_a, value);
    } else if (row.text("table") == "B") {
      EXPECT_EQ(reba_score({.upper_arm = a, .lower_arm = b, .wrist = row.whole("k3")}).table_b,
                value);
    }
  }
  // scores A and B by all parts, and what table C makes of them
  std::array<std::array<int, 13>, 13> table{};
  for (const TsvRow& row : rows) {
    if (row.text("table") != "C") continue;
    table.at(static_cast<std::size_t>(row.whole("k1")))
        .at(static_cast<std::size_t>(row.whole("k2"))) = row.whole("value");
  }
  for (int trunk = 1; trunk <= 5; ++trunk) {
    for (int legs = 1; legs <= 4; ++legs) {
      for (int load = 0; load <= 3; ++load) {
        for (int upper = 1; upper <= 6; ++upper) {
          for (int coupling = 0; coupling <= 3; ++coupling) {
            for (int wrist = 1; wrist <= 3; ++wrist) {
              const RebaScore score = reba_score({.neck = 3,
                                                  .trunk = trunk,
                                                  .legs = legs,
                                                  .load = load,
                                                  .upper_arm = upper,
                                                  .wrist = wrist,
                                                  .coupling = coupling});
              ASSERT_EQ(score.table_c, table.at(static_cast<std::size_t>(score.score_a))
                                           .at(static_cast<std::size_t>(score.score_b)));
            }
          }
        }
      }
    }
  }
}

TEST(PostureFormulas, TablesOfRulaAgree) {
  SHG_ROWS(rows, "rula_tables.tsv", 400);
  int differ = 0;
  for (const TsvRow& row : rows) {
    const std::string& table = row.text("table");
    const int a = row.whole("k1");
    const int b = row.whole("k2");
    const int value = row.whole("value");
    if (table == "A" || table == "A_old") {
      const RulaParts parts{
          .upper_arm = a, .lower_arm = b, .wrist = row.whole("k3"), .wrist_twist = row.whole("k4")};
      const bool older = table == "A_old";
      EXPECT_EQ(rula_score(parts, older ? RulaEdition::older : RulaEdition::present).table_a,
                value);
      differ += older && rula_score(parts).table_a != value ? 1 : 0;
    } else if (table == "B") {
      EXPECT_EQ(rula_score({.neck = a, .trunk = b, .legs = row.whole("k3")}).table_b, value);
    } else {
      // an arm and a trunk of these scores, or of such with muscle use and force
      bool found = false;
      for (int n = 0; n < 72 * 36 * 5; ++n) {
        const int added = n / 2592;
        const RulaScore score = rula_score({.upper_arm = 1 + n % 6,
                                            .lower_arm = 1 + n / 6 % 3,
                                            .wrist = 1 + n / 18 % 4,
                                            .muscle = added > 3 ? 1 : 0,
                                            .force = std::min(added, 3),
                                            .neck = 1 + n / 72 % 6,
                                            .trunk = 1 + n / 432 % 6});
        if (std::min(score.score_c, 8) != a || std::min(score.score_d, 7) != b) continue;
        EXPECT_EQ(score.score, value) << a << ' ' << b;
        found = true;
      }
      EXPECT_TRUE(found) << a << ' ' << b;
    }
  }
  EXPECT_EQ(differ, 31);
}

TEST(PostureFormulas, RebaRowsAgree) {
  SHG_ROWS(rows, "reba_rows.tsv", 60);
  for (const TsvRow& row : rows) {
    const RebaScore score =
        reba_score({row.whole("neck"), row.whole("trunk"), row.whole("legs"), row.whole("load"),
                    row.whole("upper_arm"), row.whole("lower_arm"), row.whole("wrist"),
                    row.whole("coupling"), row.whole("activity")});
    EXPECT_EQ(score.table_a, row.whole("table_a")) << row.text("id");
    EXPECT_EQ(score.score_a, row.whole("score_a")) << row.text("id");
    EXPECT_EQ(score.table_b, row.whole("table_b")) << row.text("id");
    EXPECT_EQ(score.score_b, row.whole("score_b")) << row.text("id");
    EXPECT_EQ(score.table_c, row.whole("table_c")) << row.text("id");
    EXPECT_EQ(score.score, row.whole("reba")) << row.text("id");
  }
}

TEST(PostureFormulas, RulaRowsAgree) {
  SHG_ROWS(rows, "rula_rows.tsv", 30);
  for (const TsvRow& row : rows) {
    const RulaParts parts{row.whole("upper_arm"),   row.whole("lower_arm"), row.whole("wrist"),
                          row.whole("wrist_twist"), row.whole("muscle"),    row.whole("force"),
                          row.whole("neck"),        row.whole("trunk"),     row.whole("legs")};
    const RulaScore score = rula_score(parts);
    EXPECT_EQ(score.table_a, row.whole("table_a")) << row.text("id");
    EXPECT_EQ(score.score_c, row.whole("score_c")) << row.text("id");
    EXPECT_EQ(score.table_b, row.whole("table_b")) << row.text("id");
    EXPECT_EQ(score.score_d, row.whole("score_d")) << row.text("id");
    EXPECT_EQ(score.score, row.whole("rula")) << row.text("id");
    EXPECT_EQ(score.level, row.whole("level")) << row.text("id");
    EXPECT_EQ(rula_score(parts, RulaEdition::older).score, row.whole("rula_old")) << row.text("id");
  }
}

TEST(PostureFormulas, SubScoresOutOfRangeAreRefused) {
  EXPECT_THROW((void)reba_score({.legs = 5}), PreconditionError);
  EXPECT_THROW((void)reba_score({.load = -1}), PreconditionError);
  EXPECT_THROW((void)rula_score({.wrist_twist = 0}), PreconditionError);
}

// Borders that an ergonomics text and the programs agree on.
TEST(PostureFormulas, ZonesHaveTheirBorders) {
  EXPECT_EQ(zone_of(ZonePart::trunk, radians(20.0)), 0);
  EXPECT_EQ(zone_of(ZonePart::trunk, radians(20.1)), 1);
  EXPECT_EQ(zone_of(ZonePart::trunk, radians(60.1)), 2);
  EXPECT_EQ(zone_of(ZonePart::trunk, radians(-5.1)), -1);
  EXPECT_EQ(zone_of(ZonePart::trunk_aside, radians(10.1)), 1);
  EXPECT_EQ(zone_of(ZonePart::upper_arm, radians(61.0)), 2);
  EXPECT_EQ(zone_of(ZonePart::head_inclination, radians(35.0)), 1);
  EXPECT_EQ(zone_verdict(ZonePart::trunk, 1, Recurrence::held), ZoneVerdict::conditional);
  EXPECT_EQ(zone_verdict(ZonePart::trunk, 2, Recurrence::held), ZoneVerdict::not_acceptable);
  EXPECT_EQ(zone_verdict(ZonePart::trunk, 2, Recurrence::rare), ZoneVerdict::unknown);
  for (const auto& part : kEnumWords<ZonePart>) {
    for (const auto& recurrence : kEnumWords<Recurrence>) {
      if (part.value == ZonePart::head_inclination && recurrence.value != Recurrence::held)
        continue;
      EXPECT_EQ(zone_verdict(part.value, 0, recurrence.value), ZoneVerdict::acceptable);
    }
  }
}

TEST(PostureFormulas, WorseSubScoresAreNeverBetter) {
  Random random(2, 0);
  const auto worse = [&random](int& part, int most) { part = drawn(random, part, most); };
  for (int n = 0; n < kFormulaCases; ++n) {
    RebaParts parts{drawn(random, 1, 3), drawn(random, 1, 5), drawn(random, 1, 4),
                    drawn(random, 0, 3), drawn(random, 1, 6), drawn(random, 1, 2),
                    drawn(random, 1, 3), drawn(random, 0, 3), drawn(random, 0, 3)};
    const int score = reba_score(parts).score;
    ASSERT_TRUE(score >= 1 && score <= 15);
    worse(parts.trunk, 5);
    worse(parts.load, 3);
    worse(parts.upper_arm, 6);
    ASSERT_GE(reba_score(parts).score, score);
    RulaParts arm{drawn(random, 1, 6), drawn(random, 1, 3), drawn(random, 1, 4),
                  drawn(random, 1, 2), drawn(random, 0, 1), drawn(random, 0, 3),
                  drawn(random, 1, 6), drawn(random, 1, 6), drawn(random, 1, 2)};
    const int grand = rula_score(arm).score;
    ASSERT_TRUE(grand >= 1 && grand <= 7);
    worse(arm.force, 3);
    worse(arm.neck, 6);
    worse(arm.wrist, 4);
    ASSERT_GE(rula_score(arm).score, grand);
  }
}

}  // namespace
}  // namespace shigusa
