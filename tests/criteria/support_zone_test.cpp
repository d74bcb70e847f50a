// SPDX-License-Identifier: MIT
#include "criteria/support_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "simd/pack.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

double inside(const std::vector<SupportEdge>& edges, const Vec3d& p) {
  double nearest = 1e9;
  for (const SupportEdge& e : edges) nearest = std::fmin(nearest, e.offset + e.x * p.x + e.z * p.z);
  return nearest;
}

class TwoHeels : public testing::Test {
 protected:
  const PosedBody posed = human_body({.heels = true});
  const std::size_t right = static_cast<std::size_t>(posed.body.feet()[0].heel->toes);
  const std::size_t left = static_cast<std::size_t>(posed.body.feet()[1].heel->toes);

  [[nodiscard]] std::vector<double> with_toes(double right_angle, double left_angle) const {
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    angles[right] = right_angle;
    angles[left] = left_angle;
    return angles;
  }
  [[nodiscard]] Vec3d point(double ahead) const {
    const Vec3d toes = posed.body.base().translation;
    return {0.0, 1.0, toes.z + ahead};
  }
};

TEST_F(TwoHeels, SolesBearWhileTheHeelsAreDown) {
  const PosedBody flat = human_body();
  const SupportZone<double> zone(posed, posed.home);
  for (const double ahead : {-0.3, -0.1, 0.0, 0.03, 0.2}) {
    EXPECT_NEAR(zone.inside(point(ahead), with_toes(0.0, 0.0)),
                inside(support_edges(flat, flat.home), point(ahead)), 1e-12);
  }
}

TEST_F(TwoHeels, ForefeetAloneBearOnceBothAreLifted) {
  const SupportZone<double> zone(posed, posed.home);
  const std::vector<double> tiptoe = with_toes(radians(20.0), radians(30.0));
  // 3 cm behind the toes' joints is 3 cm outside, but that the inner corners of feet turned out
  // stand farther back
  const double corner =
      0.5 * StatureFractions::kFootBreadth * posed.body.stature() * sin_cos(kStandingToeOut).sin;
  EXPECT_NEAR(zone.inside(point(-0.03), tiptoe), -0.03 + corner, 1e-6);
  EXPECT_GT(zone.inside(point(0.03), tiptoe), 0.02);
  EXPECT_GT(zone.inside(point(-0.03), with_toes(0.0, 0.0)), 0.03);
}

TEST_F(TwoHeels, OneLiftedLeavesTheOthersSole) {
  const std::vector<Vec3d> corners = support_polygon(posed, posed.home, 1U);
  double right_back = 1.0;
  double left_back = 1.0;
  for (const Vec3d& c : corners)
    (c.x < 0.0 ? right_back : left_back) = std::fmin(c.x < 0.0 ? right_back : left_back, c.z);
  EXPECT_GT(right_back, left_back + 0.15);
}

TEST_F(TwoHeels, GoOverFromTheOneToTheOtherInProportion) {
  const SupportZone<double> zone(posed, posed.home);
  const Vec3d p = point(-0.05);
  const auto at = [&](double r, double l) {
    return zone.inside(p, with_toes(r * kHeelLifts, l * kHeelLifts));
  };
  EXPECT_NEAR(at(0.5, 0.0), 0.5 * (at(0.0, 0.0) + at(1.0, 0.0)), 1e-12);
  EXPECT_NEAR(at(0.25, 0.75),
              0.75 * 0.25 * at(0, 0) + 0.25 * 0.25 * at(1, 0) + 0.75 * 0.75 * at(0, 1) +
                  0.25 * 0.75 * at(1, 1),
              1e-12);
  EXPECT_EQ(at(1.0, 1.0), at(4.0, 9.0));
}

TEST_F(TwoHeels, LanesSeeWhatDoubleSees) {
  using Lanes = Pack<float, 4>;
  const SupportZone<double> zone(posed, posed.home);
  const SupportZone<Lanes> lanes(posed, posed.home);
  const float toes[] = {0.0F, 0.02F, 0.05F, 0.3F};
  std::vector<Lanes> angles(posed.body.dofs().size());
  for (std::size_t d = 0; d < angles.size(); ++d) {
    angles[d] = Lanes(static_cast<float>(posed.home.angles[d]));
  }
  for (int k = 0; k < 4; ++k) {
    angles[right].set(k, toes[k]);
    angles[left].set(k, toes[k]);
  }
  const Vec3d p = point(-0.02);
  const Vec3<Lanes> packed = to_scalar<Lanes>(p);
  const Lanes found = lanes.inside(packed, angles);
  for (int k = 0; k < 4; ++k) {
    const auto q = static_cast<double>(toes[k]);
    EXPECT_NEAR(static_cast<double>(found[k]), zone.inside(p, with_toes(q, q)), 1e-6);
  }
}

}  // namespace
}  // namespace shigusa
