// SPDX-License-Identifier: MIT
#include "criteria/support_margin.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/motions.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A mass on a rod of 1 m about x, on a sole that ends 0.15 m ahead and 0.05 m behind.
PosedBody on_a_foot() {
  BodyDefinition body = chain_definition({{Axis::x, 1.0, 1.0}});
  body.feet.push_back({.name = "foot",
                       .node = "foot",
                       .outline = {{.3, 0, .15}, {-.3, 0, .15}, {-.3, 0, -.05}, {.3, 0, -.05}}});
  return at_zero(body);
}

TEST(SupportMargins, OfAStillBodyAreBothOfItsCentreOfMass) {
  const BodyModel body = on_a_foot();
  for (const double ahead : {0.0, 0.12, 0.4, -0.2}) {
    const double q = std::asin(ahead);
    const auto margins = support_margins(body, motion_through(body, {{q}, {q}, {q}}));
    ASSERT_TRUE(margins);
    const double inside = std::fmin(0.15 - ahead, ahead + 0.05);
    EXPECT_NEAR(margins->centre_of_mass.distance, inside, 1e-9);
    EXPECT_NEAR(margins->pressure.distance, inside, 1e-9);
    EXPECT_EQ(margins->centre_of_mass.time, 0.0);
  }
}

TEST(SupportMargins, AreTheLeastOnesAndTellWhen) {
  const BodyModel body = on_a_foot();
  const Motion motion = motion_through(body, {{0.0}, {0.1}, {0.3}, {0.2}});
  const auto margins = support_margins(body, motion);
  ASSERT_TRUE(margins);
  EXPECT_NEAR(margins->centre_of_mass.distance, 0.15 - std::sin(0.3), 1e-9);
  EXPECT_NEAR(margins->centre_of_mass.time, 2 * motion.clip.frame_time, 1e-12);
  // so fast that the floor would have to pull
  EXPECT_LT(margins->pressure.distance, margins->centre_of_mass.distance);
}

// h a / g behind a mass with acceleration a ahead.
TEST(SupportMargins, OfThePressureKnowsWhatPushesTheMass) {
  const BodyModel body = on_a_foot();
  const double e = 1e-5;
  const Motion motion = motion_through(body, {{0.0}, {e}, {e}});
  const double a = e / (motion.clip.frame_time * motion.clip.frame_time);
  const auto margins = support_margins(body, motion);
  ASSERT_TRUE(margins);
  EXPECT_NEAR(margins->pressure.distance, 0.05 - a / kGravity, 1e-4);
  EXPECT_EQ(margins->pressure.time, 0.0);
}

TEST(SupportMargins, AreNoneOfABodyWithoutFeet) {
  const BodyModel body = chain({{Axis::x, 1.0, 1.0}});
  EXPECT_FALSE(support_margins(body, motion_through(body, {{1.0}, {-1.0}})));
}

}  // namespace
}  // namespace shigusa
