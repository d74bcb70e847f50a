// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/ergonomics.hpp>

#include "support/ergonomics_rows.hpp"

// The forces at L5/S1 against the rows of shared/ergonomics, whose sources its README names.
namespace shigusa {
namespace {

using testing_support::TsvRow;

TEST(BackFormulas, OneMuscleAgrees) {
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

TEST(BackFormulas, LimitsOfTheBackFallWithAge) {
  EXPECT_DOUBLE_EQ(back_limit(18, Sex::male), 5400.0);
  EXPECT_DOUBLE_EQ(back_limit(60, Sex::female), 1800.0);
  EXPECT_DOUBLE_EQ(back_limit(40, Sex::male), 3800.0);
}

}  // namespace
}  // namespace shigusa
