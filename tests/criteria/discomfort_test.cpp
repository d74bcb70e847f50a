// SPDX-License-Identifier: MIT
#include "criteria/discomfort.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr int kHinges = 8;

// Eight hinges with the range -1 to 2 rad, so that one of them alone does not reach the scale.
BodyDefinition hinges() {
  BodyDefinition body = chain_definition(std::vector<Pendulum>(kHinges));
  for (Dof& dof : body.dofs) {
    dof.lower = -1.0;
    dof.upper = 2.0;
  }
  return body;
}

double penalty_at(const PosedBody& posed, const std::vector<std::vector<double>>& frames,
                  double share = kDiscomfortShare) {
  return penalty_by<Discomfort>(posed, motion_through(posed, frames), share);
}

std::vector<double> first_at(double angle) {
  std::vector<double> q(kHinges, 0.0);
  q[0] = angle;
  return q;
}

// Discomfort of one joint alone, 0..1.
double of_one(double angle) {
  return penalty_at(at_zero(hinges()), {first_at(angle)}) * kDiscomfortShare * kHinges;
}

TEST(Discomfort, OfNeutralIsZero) { EXPECT_EQ(of_one(0.0), 0.0); }

TEST(Discomfort, IsHalfTheSquareOfTheWay) {
  EXPECT_NEAR(of_one(1.0), 0.5 * 0.25, 1e-12);
  EXPECT_NEAR(of_one(-0.5), 0.5 * 0.25, 1e-12);
  EXPECT_NEAR(of_one(0.88 * 2.0), 0.5 * 0.88 * 0.88, 1e-12);
}

TEST(Discomfort, RisesSteeplyAtTheEnds) {
  EXPECT_NEAR(of_one(0.94 * 2.0), 0.5 * 0.94 * 0.94 + 0.5 * 0.25, 1e-12);
  EXPECT_NEAR(of_one(-0.94), 0.5 * 0.94 * 0.94 + 0.5 * 0.25, 1e-12);
}

TEST(Discomfort, IsFullAtALimitAndNoMoreBeyond) {
  EXPECT_NEAR(of_one(2.0), 1.0, 1e-12);
  EXPECT_NEAR(of_one(-1.0), 1.0, 1e-12);
  EXPECT_NEAR(of_one(2.5), 1.0, 1e-12);
}

TEST(Discomfort, EndsRiseAsThePublishedCurveDoes) {
  // (0.5 sin(5 s + π/2) + 1)^100 over its value at the limit, s being the share of the range left
  for (double s = 0.0; s <= 1.0; s += 0.001) {
    const double published = std::pow((0.5 * std::sin(5.0 * s + kPi / 2) + 1.0) / 1.5, 100.0);
    const double left = std::fmax(0.0, 1.0 - s / kDiscomfortEnd);
    if (s < 0.6) {  // farther off, the sine comes back
      EXPECT_NEAR(left * left, published, 0.16) << s;
    }
  }
}

TEST(Discomfort, IsFullWithAQuarterOfTheJointsAtTheirEnds) {
  std::vector<double> q(kHinges, 0.0);
  q[2] = 2.0;
  q[5] = -1.0;
  EXPECT_NEAR(penalty_at(at_zero(hinges()), {q}), 1.0, 1e-12);
  EXPECT_EQ(penalty_at(at_zero(hinges()), {std::vector<double>(kHinges, 2.0)}), 1.0);
}

TEST(Discomfort, IsHalfTheMeanAndHalfTheWorst) {
  const PosedBody posed = at_zero(hinges());
  const double once = penalty_at(posed, {first_at(1.5)});
  EXPECT_NEAR(penalty_at(posed, {first_at(0), first_at(1.5), first_at(0), first_at(0)}),
              once * (0.5 / 4 + 0.5), 1e-12);
}

TEST(Discomfort, KneesAndElbowsMayBeStraight) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const std::vector<double> straight(posed.body.dofs().size(), 0.0);
    EXPECT_EQ(penalty_at(posed, {straight}), 0.0);
    EXPECT_LT(penalty_at(posed, {{posed.home.angles.begin(), posed.home.angles.end()}}), 0.02);
  }
}

TEST(Discomfort, ABentKneeEasesTheHip) {
  const PosedBody posed = full_body();
  const auto at = [&](double hip, double knee) {
    std::vector<double> q(posed.body.dofs().size(), 0.0);
    q[static_cast<std::size_t>(*posed.body.find_dof("right_hip.flexion"))] = hip;
    q[static_cast<std::size_t>(*posed.body.find_dof("right_knee.flexion"))] = knee;
    return penalty_at(posed, {q});
  };
  const double hip = at(radians(115), 0.0);
  EXPECT_NEAR(hip, 1.0 / 18 / kDiscomfortShare, 1e-12);
  const double knee = at(0.0, radians(60));
  // 115° of 165°: less than 0.88 of the way
  const double u = 115.0 / 165.0;
  EXPECT_NEAR(at(radians(115), radians(60)) - knee, 0.5 * u * u / 18 / kDiscomfortShare, 1e-12);
}

TEST(Discomfort, NeutralIsALimitWhereZeroIsOutside) {
  BodyDefinition definition = hinges();
  definition.dofs[0].lower = 0.5;
  const PosedBody posed = at_zero(definition);
  EXPECT_EQ(penalty_at(posed, {first_at(0.5)}), 0.0);
  EXPECT_NEAR(penalty_at(posed, {first_at(1.25)}) * kDiscomfortShare * kHinges, 0.125, 1e-12);
}

TEST(Discomfort, ShareIsASetting) {
  const PosedBody posed = at_zero(hinges());
  EXPECT_NEAR(penalty_at(posed, {first_at(1.0)}, 0.5), 0.5 * penalty_at(posed, {first_at(1.0)}),
              1e-15);
}

}  // namespace
}  // namespace shigusa
