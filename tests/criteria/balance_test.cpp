// SPDX-License-Identifier: MIT
#include "criteria/balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "body/anthropometry.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A mass on a rod of 1 m, standing on the world's origin.
const PosedBody& rod() {
  static const PosedBody posed = chain({{Axis::x, 1.0, 1.0}});
  return posed;
}

// The penalty of leaning by these angles, frame by frame.
double penalty_of(const std::vector<double>& leans, double scale = kBalanceLean) {
  std::vector<std::vector<double>> frames;
  for (const double lean : leans) frames.push_back({lean});
  return penalty_by<Balance>(rod(), motion_through(rod(), frames), scale);
}

TEST(Balance, IsZeroAboveTheSupport) { EXPECT_EQ(penalty_of({0.0, 0.0}), 0.0); }

TEST(Balance, IsTheLeanAsAShare) {
  // the ratio of a rod that leans by θ is tan θ
  EXPECT_NEAR(penalty_of({0.1}), std::tan(0.1) / 0.2, 1e-14);
}

TEST(Balance, CountsAllDirectionsAlike) {
  EXPECT_NEAR(penalty_of({-0.1}), penalty_of({0.1}), 1e-15);
  const PosedBody sideways = chain({{Axis::z, 1.0, 1.0}});
  EXPECT_NEAR(penalty_by<Balance>(sideways, motion_through(sideways, {{0.1}})), penalty_of({0.1}),
              1e-15);
}

TEST(Balance, IsHalfTheMeanAndHalfTheWorst) {
  const double r = std::tan(0.08);
  EXPECT_NEAR(penalty_of({0.0, 0.08, 0.0, 0.0}), (0.5 * r / 4 + 0.5 * r) / 0.2, 1e-14);
}

TEST(Balance, IsFullAtTheLeanAndBeyond) {
  EXPECT_NEAR(penalty_of({std::atan(0.2)}), 1.0, 1e-14);
  EXPECT_EQ(penalty_of({0.5}), 1.0);
}

TEST(Balance, LyingDownIsFull) {
  EXPECT_EQ(penalty_of({kPi / 2}), 1.0);
  EXPECT_EQ(penalty_of({kPi - 0.1}), 1.0);
}

TEST(Balance, NeverFallsWithMoreLean) {
  double before = 0.0;
  for (double lean = 0.0; lean < 1.5; lean += 0.01) {
    const double now = penalty_of({0.0, lean});
    EXPECT_GE(now, before - 1e-15);
    before = now;
  }
}

TEST(Balance, LeanIsASetting) {
  EXPECT_NEAR(penalty_of({0.1}, 0.4), 0.5 * penalty_of({0.1}), 1e-15);
}

TEST(SupportCentre, IsTheMiddleOfTheStandingFeet) {
  const PosedBody posed = full_body();
  const Vec3d centre = support_centre(posed, posed.home);
  EXPECT_NEAR(centre.x, 0.0, 1e-12);
  EXPECT_NEAR(centre.y, 0.0, 1e-12);
  // the sole reaches from a quarter of the foot's length behind the ankle to three quarters ahead
  const double ahead =
      0.25 * StatureFractions::kFootLength * posed.body.stature() * std::cos(radians(7));
  const double ankle = posed.body.base().translation.z;
  EXPECT_NEAR(centre.z, ankle + ahead, 1e-12);
}

TEST(SupportCentre, OfTheHalfBodyCountsBothFeet) {
  EXPECT_NEAR(support_centre(half_body(), half_body().home).x, 0.0, 1e-12);
}

TEST(SupportCentre, OfABodyWithoutFeetIsItsBase) {
  EXPECT_EQ(support_centre(rod(), rod().home), (Vec3d{0, 0, 0}));
}

}  // namespace
}  // namespace shigusa
