// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/ergonomics.hpp>

#include "support/ergonomics_rows.hpp"

// The revised NIOSH lifting equation against the rows of shared/ergonomics, whose sources its
// README names.
namespace shigusa {
namespace {

using testing_support::drawn;
using testing_support::kFormulaCases;
using testing_support::TsvRow;

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

TEST(LiftingFormulas, LiftsAgree) {
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

TEST(LiftingFormulas, FrequencyFactorsAgree) {
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

TEST(LiftingFormulas, CompositeIndicesAgree) {
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

TEST(LiftingFormulas, WorseLiftsAreNeverAllowedMore) {
  Random random(1, 0);
  int allowed = 0;
  for (int n = 0; n < kFormulaCases; ++n) {
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
  EXPECT_GT(allowed, kFormulaCases / 20);
  EXPECT_LT(allowed, kFormulaCases);
}

TEST(LiftingFormulas, CompositeIndexGrowsWithTasksInAnyOrder) {
  Random random(3, 0);
  int defined = 0;
  for (int n = 0; n < kFormulaCases; ++n) {
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
  EXPECT_GT(defined, kFormulaCases / 10);
}

TEST(LiftingFormulas, NumbersThatAreNoneAreRefused) {
  EXPECT_FALSE(lift_index({.load = -1.0}));
  EXPECT_FALSE(lift_index({.horizontal = __builtin_nan("")}));
  EXPECT_FALSE(composite_index(std::array{LiftTask{.free_limit = __builtin_inf()}}));
  const auto far = lift_index({.load = 5.0, .horizontal = 0.64});
  EXPECT_EQ(far->notes.front().key, "lift_too_far");
  EXPECT_FALSE(far->index);
}

}  // namespace
}  // namespace shigusa
