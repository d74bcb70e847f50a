// SPDX-License-Identifier: MIT
#include "criteria/balance_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A mass on a rod of 1 m about `axis`, on a foot with this outline.
PosedBody on_a_foot(const std::vector<Vec3d>& outline, Axis axis = Axis::x) {
  BodyDefinition body = chain_definition({{axis, 1.0, 1.0}});
  body.feet.push_back({.name = "foot", .node = "foot", .outline = outline});
  return at_zero(body);
}

// A sole 0.2 m long (0.15 m ahead) and 0.1 m wide (0.06 m to the left).
const std::vector<Vec3d> kSole{{.06, 0, .15}, {-.04, 0, .15}, {-.04, 0, -.05}, {.06, 0, -.05}};

// The penalty with the centre of mass this far ahead (m), frame by frame.
double penalty_at(const std::vector<double>& ahead, double margin = kBalanceReserve) {
  const PosedBody posed = on_a_foot(kSole);
  std::vector<std::vector<double>> frames;
  for (const double z : ahead) frames.push_back({std::asin(z)});
  return penalty_by<BalanceZone>(posed, motion_through(posed, frames), margin);
}

// Distance of a point inside the polygon.
double inside(const std::vector<SupportEdge>& edges, double x, double z) {
  double nearest = 1e9;
  for (const SupportEdge& e : edges) nearest = std::fmin(nearest, e.offset + e.x * x + e.z * z);
  return nearest;
}

TEST(BalanceZone, IsZeroWellInside) { EXPECT_EQ(penalty_at({0.0, 0.05, 0.1, 0.119, -0.019}), 0.0); }

TEST(BalanceZone, IsAHalfAtTheEdge) {
  EXPECT_NEAR(penalty_at({0.15}), 0.5, 1e-12);
  EXPECT_NEAR(penalty_at({-0.05}), 0.5, 1e-12);
}

TEST(BalanceZone, GrowsInProportionAcrossTheMargin) {
  EXPECT_NEAR(penalty_at({0.135}), 0.25, 1e-12);
  EXPECT_NEAR(penalty_at({0.165}), 0.75, 1e-12);
}

TEST(BalanceZone, IsFullAMarginOutsideAndBeyond) {
  EXPECT_NEAR(penalty_at({0.18}), 1.0, 1e-12);
  EXPECT_EQ(penalty_at({0.5}), 1.0);
}

TEST(BalanceZone, CountsTheSides) {
  // about z a positive angle leans to the right, to smaller x
  const PosedBody posed = on_a_foot(kSole, Axis::z);
  const auto at = [&](double x) {
    return penalty_by<BalanceZone>(posed, motion_through(posed, {{std::asin(-x)}}));
  };
  EXPECT_EQ(at(0.02), 0.0);
  EXPECT_NEAR(at(0.06), 0.5, 1e-12);
  EXPECT_NEAR(at(-0.04), 0.5, 1e-12);
}

TEST(BalanceZone, IsHalfTheMeanAndHalfTheWorst) {
  EXPECT_NEAR(penalty_at({0.0, 0.15, 0.0, 0.0}), 0.5 * 0.5 / 4 + 0.5 * 0.5, 1e-12);
}

TEST(BalanceZone, MarginIsASetting) { EXPECT_NEAR(penalty_at({0.135}, 0.02), 0.125, 1e-12); }

TEST(BalanceZone, OfUprightStandingIsZero) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const std::vector<double> start(posed.home.angles.begin(), posed.home.angles.end());
    EXPECT_EQ(penalty_by<BalanceZone>(posed, motion_through(posed, {start})), 0.0)
        << posed.body.name();
  }
}

TEST(BalanceZone, OfABodyWithoutFeetIsZero) {
  const PosedBody posed = chain({{}});
  EXPECT_EQ(penalty_by<BalanceZone>(posed, motion_through(posed, {{1.5}})), 0.0);
}

TEST(SupportPolygon, LeavesOutWhatIsHollowOrTwice) {
  std::vector<Vec3d> outline = kSole;
  outline.push_back({0.0, 0, 0.0});
  outline.push_back({0.01, 0, 0.15});  // on an edge
  outline.push_back(kSole[1]);
  EXPECT_EQ(support_polygon(on_a_foot(outline), on_a_foot(outline).home).size(), 4u);
}

TEST(SupportPolygon, GoesCounterClockwiseSeenFromAbove) {
  for (const PosedBody& posed : {on_a_foot(kSole), half_body(), full_body()}) {
    const std::vector<Vec3d> corners = support_polygon(posed, posed.home);
    ASSERT_GE(corners.size(), 4u);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3d& a = corners[i];
      const Vec3d& b = corners[(i + 1) % corners.size()];
      const Vec3d& c = corners[(i + 2) % corners.size()];
      EXPECT_GT(cross(b - a, c - b).y, 0.0);
    }
  }
}

TEST(SupportPolygon, HoldsAllOfBothSoles) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const std::vector<SupportEdge> edges = support_edges(posed, posed.home);
    const Kinematics<double> now = placed(posed, posed.home.angles);
    double nearest = 1.0;
    for (const Foot& foot : posed.body.feet()) {
      for (const Vec3d& corner : foot.outline) {
        const Vec3d p = now.point(foot.link, corner);
        nearest = std::fmin(nearest, inside(edges, p.x, p.z));
      }
    }
    EXPECT_NEAR(nearest, 0.0, 1e-12);  // no corner outside, and some on the edge
    // between the feet is inside
    EXPECT_GT(
        inside(edges, 0.0, now.point(posed.body.feet()[0].link, posed.body.feet()[0].centre).z),
        0.05);
  }
}

TEST(SupportEdges, MeasureTheDistanceToTheEdge) {
  const std::vector<SupportEdge> edges = support_edges(on_a_foot(kSole), on_a_foot(kSole).home);
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_NEAR(inside(edges, 0.01, 0.0), 0.05, 1e-12);
  EXPECT_NEAR(inside(edges, 0.05, 0.1), 0.01, 1e-12);
  EXPECT_NEAR(inside(edges, 0.0, 0.25), -0.1, 1e-12);
  EXPECT_NEAR(inside(edges, -0.14, 0.0), -0.1, 1e-12);
}

TEST(SupportEdges, OfALineHaveNoInside) {
  const PosedBody posed = on_a_foot({{0, 0, 0}, {0, 0, 0.2}});
  const std::vector<SupportEdge> edges = support_edges(posed, posed.home);
  EXPECT_NEAR(inside(edges, 0.0, 0.1), 0.0, 1e-12);
  EXPECT_LT(inside(edges, 0.01, 0.1), 0.0);
}

}  // namespace
}  // namespace shigusa
