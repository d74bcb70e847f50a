// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/ergonomics.hpp>
#include <shigusa/run.hpp>

#include "dynamics/inverse_dynamics.hpp"
#include "support/tsv.hpp"

// The formulas against the rows of shared/ergonomics, whose sources its README names.
namespace shigusa {
namespace {

using testing_support::ergonomics_rows;
using testing_support::TsvRow;

// Rows of a file; skips the test where the folder is absent, and fails for a file without rows.
#define SHG_ROWS(rows, file, least)                                    \
  const std::vector<TsvRow> rows = ergonomics_rows(file);              \
  if (rows.empty()) GTEST_SKIP() << "no shared/ergonomics/" << (file); \
  ASSERT_GE(rows.size(), std::size_t{least})

// Thresholds of the methods' own words, which give neutral no width.
PostureThresholds without_widths() {
  return {.upright = 0.0, .straight_wrist = 0.0, .neck_extends = 0.0};
}

TEST(CostFormulas, BaseScoresOfAnglesAgree) {
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
TEST(CostFormulas, TablesOfRebaAgree) {
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

TEST(CostFormulas, TablesOfRulaAgree) {
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

TEST(CostFormulas, RebaRowsAgree) {
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

TEST(CostFormulas, RulaRowsAgree) {
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

TEST(CostFormulas, SubScoresOutOfRangeAreRefused) {
  EXPECT_THROW((void)reba_score({.legs = 5}), PreconditionError);
  EXPECT_THROW((void)reba_score({.load = -1}), PreconditionError);
  EXPECT_THROW((void)rula_score({.wrist_twist = 0}), PreconditionError);
}

// The constants of the row's units, with its load constant; the metric ones are in metres.
LiftConstants constants_of(const TsvRow& row) {
  LiftConstants constants = row.text("unit") == "si" ? kMetricLift : kUsLift;
  constants.load = row.number("lc");
  return constants;
}
double length(const TsvRow& row, const std::string& name) {
  return row.text("unit") == "si" ? row.number(name) / 100.0 : row.number(name);
}
LiftingTime time_of(const TsvRow& row) {
  return value_of<LiftingTime>(row.text("duration"), "duration").value();
}
Lift lift_of(const TsvRow& row) {
  return {.load = row.number("L"),
          .horizontal = length(row, "H"),
          .vertical = length(row, "V"),
          .travel = length(row, "D"),
          .asymmetry = radians(row.number("A")),
          .frequency = row.number("F"),
          .time = time_of(row),
          .origin_vertical = length(row, "V_origin"),
          .coupling = value_of<Coupling>(row.text("coupling"), "coupling").value()};
}

constexpr double kDigits = 1.5e-6;  // of the rows

TEST(CostFormulas, LiftsAgree) {
  SHG_ROWS(rows, "niosh_examples.tsv", 70);
  for (const TsvRow& row : rows) {
    const auto lift = lift_index(lift_of(row), constants_of(row));
    ASSERT_TRUE(lift);
    const std::pair<const char*, double> factors[] = {
        {"HM", lift->horizontal}, {"VM", lift->vertical},  {"DM", lift->travel},
        {"AM", lift->asymmetry},  {"FM", lift->frequency}, {"CM", lift->coupling},
        {"RWL", lift->limit}};
    for (const auto& [name, factor] : factors) {
      EXPECT_NEAR(factor, row.number(name), kDigits * max(1.0, factor))
          << row.text("id") << ' ' << name;
    }
    ASSERT_EQ(lift->index.has_value(), row.has("LI")) << row.text("id");
    if (lift->index) {
      EXPECT_NEAR(*lift->index, row.number("LI"), kDigits * max(1.0, *lift->index))
          << row.text("id");
    } else {
      EXPECT_FALSE(lift->notes.empty()) << row.text("id");
    }
    EXPECT_EQ(lift->between, row.whole("open") == 1) << row.text("id");
  }
}

TEST(CostFormulas, FrequencyFactorsAgree) {
  SHG_ROWS(rows, "niosh_fm.tsv", 17);
  for (const TsvRow& row : rows) {
    for (const LiftingTime time :
         {LiftingTime::brief, LiftingTime::moderate, LiftingTime::lengthy}) {
      for (const bool high : {false, true}) {
        const auto lift = lift_index(
            {.frequency = row.number("F"), .time = time, .origin_vertical = high ? 0.75 : 0.7499});
        const std::string column = std::string(word_of(time)) + (high ? "_high" : "_low");
        EXPECT_DOUBLE_EQ(lift->frequency, row.number(column)) << row.text("F") << ' ' << column;
      }
    }
  }
}

TEST(CostFormulas, CompositeIndicesAgree) {
  SHG_ROWS(rows, "niosh_multitask.tsv", 20);
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t last = first;
    while (last < rows.size() && rows[last].text("job") == rows[first].text("job")) ++last;
    std::vector<LiftTask> tasks;
    for (std::size_t k = last; k-- > first;) {  // the rows are in the order of the answer
      tasks.push_back({rows[k].number("FIRWL"), rows[k].number("L_max"), rows[k].number("L_avg"),
                       rows[k].number("F"), time_of(rows[k]), length(rows[k], "V_origin")});
    }
    const auto composite = composite_index(tasks, constants_of(rows[first]));
    ASSERT_TRUE(composite && composite->index) << rows[first].text("job");
    for (std::size_t k = first; k < last; ++k) {
      const LiftTaskIndex& own = composite->tasks[k - first];
      EXPECT_EQ(own.task, last - 1 - k) << rows[k].text("job");
      EXPECT_NEAR(own.frequency, rows[k].number("FM"), 3e-6);
      EXPECT_NEAR(own.limit, rows[k].number("STRWL"), 3e-6 * own.limit);
      EXPECT_NEAR(own.free_index, rows[k].number("FILI"), 3e-6);
      EXPECT_NEAR(own.index, rows[k].number("STLI"), 3e-6);
      EXPECT_NEAR(own.added, rows[k].number("dLI"), 3e-6);
    }
    EXPECT_NEAR(*composite->index, rows[first].number("CLI"), 3e-6) << rows[first].text("job");
    first = last;
  }
}

TEST(CostFormulas, OneMuscleAgrees) {
  SHG_ROWS(rows, "low_back_static.tsv", 12);
  for (const TsvRow& row : rows) {
    const double g = 9.81;  // of the rows
    const double moment =
        g * (row.number("mL") * row.number("dL") + row.number("mB") * row.number("dB"));
    const BackForces forces = back_forces(moment, g * (row.number("mL") + row.number("mB")),
                                          radians(row.number("t")), row.number("E"));
    EXPECT_NEAR(moment, row.number("M"), 1e-3 * moment);
    EXPECT_NEAR(forces.muscle, row.number("F"), 1e-4 * forces.muscle);
    EXPECT_NEAR(forces.compression, row.number("C"), 1e-4 * forces.compression);
    EXPECT_NEAR(forces.shear, row.number("S"), 1e-4 * max(1.0, forces.shear));
  }
}

TEST(CostFormulas, LimitsOfTheBackFallWithAge) {
  EXPECT_DOUBLE_EQ(back_limit(18, Sex::male), 5400.0);
  EXPECT_DOUBLE_EQ(back_limit(60, Sex::female), 1800.0);
  EXPECT_DOUBLE_EQ(back_limit(40, Sex::male), 3800.0);
}

// Borders that an ergonomics text and the programs agree on.
TEST(CostFormulas, ZonesHaveTheirBorders) {
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

constexpr int kCases = 10'000;

int drawn(Random& random, int least, int most) {
  return least + static_cast<int>(random.below(static_cast<std::uint32_t>(most - least + 1)));
}

// A drawn lift, at times out of the equation's range.
Lift drawn_lift(Random& random) {
  Lift lift;
  lift.load = random.uniform(0.0, 40.0);
  lift.horizontal = random.uniform(0.0, 0.7);
  lift.vertical = random.uniform(0.0, 1.9);
  lift.travel = random.uniform(0.0, 1.9);
  lift.asymmetry = radians(random.uniform(0.0, 150.0));
  lift.frequency = random.uniform(0.0, 16.0);
  lift.time = static_cast<LiftingTime>(drawn(random, 0, 2));
  lift.origin_vertical = random.uniform(0.0, 1.9);
  lift.coupling = static_cast<Coupling>(drawn(random, 0, 2));
  return lift;
}

TEST(CostFormulas, WorseLiftsAreNeverAllowedMore) {
  Random random(1, 0);
  int allowed = 0;
  for (int n = 0; n < kCases; ++n) {
    const Lift lift = drawn_lift(random);
    const LiftIndex own = lift_index(lift).value();
    ASSERT_TRUE(own.limit >= 0.0 && own.limit <= kMetricLift.load);
    ASSERT_EQ(own.index.has_value(), own.limit > 0.0);
    ASSERT_TRUE(own.index || !own.notes.empty());
    allowed += own.index ? 1 : 0;
    const auto not_more = [&](double Lift::*what, double by) {
      Lift worse = lift;
      worse.*what += by;
      return lift_index(worse)->limit <= own.limit;
    };
    ASSERT_TRUE(not_more(&Lift::horizontal, random.uniform(0.0, 0.3)));
    ASSERT_TRUE(not_more(&Lift::travel, random.uniform(0.0, 0.3)));
    ASSERT_TRUE(not_more(&Lift::asymmetry, random.uniform(0.0, 0.5)));
    ASSERT_TRUE(not_more(&Lift::frequency, random.uniform(0.0, 3.0)));
    if (lift.vertical >= kMetricLift.knuckles) {
      ASSERT_TRUE(not_more(&Lift::vertical, random.uniform(0.0, 0.5)));
    }
    Lift heavier = lift;
    heavier.load += 1.0;
    const LiftIndex more = lift_index(heavier).value();
    ASSERT_TRUE(!own.index || *more.index > *own.index);
  }
  EXPECT_GT(allowed, kCases / 20);
  EXPECT_LT(allowed, kCases);
}

TEST(CostFormulas, WorseSubScoresAreNeverBetter) {
  Random random(2, 0);
  const auto worse = [&random](int& part, int most) { part = drawn(random, part, most); };
  for (int n = 0; n < kCases; ++n) {
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

TEST(CostFormulas, CompositeIndexGrowsWithTasksInAnyOrder) {
  Random random(3, 0);
  int defined = 0;
  for (int n = 0; n < kCases; ++n) {
    std::vector<LiftTask> tasks;
    for (int k = drawn(random, 1, 5); k > 0; --k) {
      const double load = random.uniform(1.0, 20.0);
      tasks.push_back({random.uniform(5.0, 23.0), load, load * random.uniform(0.5, 1.0),
                       random.uniform(0.2, 3.0), static_cast<LiftingTime>(drawn(random, 0, 2)),
                       random.uniform(0.0, 1.5)});
    }
    const auto all = composite_index(tasks).value();
    ASSERT_TRUE(all.index || !all.notes.empty());
    std::reverse(tasks.begin(), tasks.end());
    const auto turned = composite_index(tasks).value();
    ASSERT_EQ(all.index.has_value(), turned.index.has_value());
    if (!all.index) continue;
    ++defined;
    ASSERT_NEAR(*all.index, *turned.index, 1e-12 * *all.index);
    ASSERT_GE(*all.index, all.tasks.front().index);
    tasks.erase(tasks.begin() +
                static_cast<std::ptrdiff_t>(tasks.size() - 1 - all.tasks.back().task));
    if (tasks.empty()) continue;
    ASSERT_LE(composite_index(tasks)->index.value(), *all.index + 1e-12);
  }
  EXPECT_GT(defined, kCases / 10);
}

TEST(CostFormulas, NumbersThatAreNoneAreRefused) {
  EXPECT_FALSE(lift_index({.load = -1.0}));
  EXPECT_FALSE(lift_index({.horizontal = __builtin_nan("")}));
  EXPECT_FALSE(composite_index(std::array{LiftTask{.free_limit = __builtin_inf()}}));
  const auto far = lift_index({.load = 5.0, .horizontal = 0.64});
  EXPECT_EQ(far->notes.front().key, "lift_too_far");
  EXPECT_FALSE(far->index);
}

}  // namespace
}  // namespace shigusa
