// SPDX-License-Identifier: MIT
#include "criteria/centre_of_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A mass on a rod of 1 m about x, on a sole that ends 0.15 m ahead and 0.05 m behind.
PosedBody on_a_foot() {
  BodyDefinition body = chain_definition({{Axis::x, 1.0, 1.0}});
  body.feet.push_back(
      {.name = "foot",
       .node = "foot",
       .outline = {{.06, 0, .15}, {-.04, 0, .15}, {-.04, 0, -.05}, {.06, 0, -.05}}});
  return at_zero(body);
}

double penalty_of(const std::vector<double>& angles, double outside = kPressureOutside) {
  const PosedBody body = on_a_foot();
  std::vector<std::vector<double>> frames;
  for (const double q : angles) frames.push_back({q});
  return penalty_by<CentreOfPressure>(body, motion_through(body, frames), outside);
}

// At rest the centre of pressure is below the centre of mass.
TEST(CentreOfPressure, OfAStillBodyIsUnderItsCentreOfMass) {
  const auto leaning = [](double ahead) { return penalty_of({std::asin(ahead)}); };
  EXPECT_EQ(leaning(0.0), 0.0);
  EXPECT_EQ(leaning(0.149), 0.0);
  EXPECT_NEAR(leaning(0.20), 0.5, 1e-9);
  EXPECT_NEAR(leaning(-0.10), 0.5, 1e-9);
  EXPECT_EQ(leaning(0.8), 1.0);
}

// h a / g behind a mass with acceleration a ahead: the mass swings by e and back, with acceleration
// a = e f² at the ends and -2 a in the middle.
TEST(CentreOfPressure, IsMovedByWhatTheMassIsPushedBy) {
  const double e = 1e-4;
  const double frame_rate = 1.0 / Clip{}.frame_time;
  const double a = e * frame_rate * frame_rate;
  const double at_ends = a / kGravity - 0.05;
  const double in_the_middle = 2.0 * a / kGravity + e - 0.15;
  ASSERT_GT(at_ends, -0.05);
  const double outside = 1.0;
  const double ends = std::fmax(at_ends, 0.0);
  const double middle = std::fmax(in_the_middle, 0.0);
  EXPECT_NEAR(penalty_of({0.0, e, 0.0}, outside),
              std::sqrt((2 * ends * ends + middle * middle) / 3), 1e-4);
  // ten times as fast, it leaves the foot
  EXPECT_GT(penalty_of({0.0, 10 * e, 0.0}), 0.5);
}

TEST(CentreOfPressure, DoesNotMatterToABodyWithoutFeet) {
  const PosedBody body = chain({{Axis::x, 1.0, 1.0}});
  EXPECT_EQ(penalty_by<CentreOfPressure>(body, motion_through(body, {{1.0}, {-1.0}})), 0.0);
}

}  // namespace
}  // namespace shigusa
