// SPDX-License-Identifier: MIT
#include "criteria/low_back.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/contact_forces.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// The penalty where both hips, or the one of the half body, give these torques (N·m, sum of the
// hips) in three frames.
double penalty_of(const PosedBody& posed, const std::vector<double>& together,
                  double share = kLowBackShare) {
  const std::vector<double> start(posed.home.angles.begin(), posed.home.angles.end());
  Motion motion = motion_through(posed, std::vector<std::vector<double>>(together.size(), start));
  const std::vector<int> hips = back_constants(posed).dofs;
  for (std::size_t f = 0; f < together.size(); ++f) {
    for (const int hip : hips) {
      motion.torques[f * start.size() + static_cast<std::size_t>(hip)] =
          together[f] / static_cast<double>(hips.size());
    }
  }
  return penalty_by<LowBack>(posed, motion, share);
}

// Moment (N·m) of the hips against gravity, from the inverse dynamics.
double hip_torque(const PosedBody& posed, const std::vector<double>& posture) {
  DynamicsWorkspace<double> work(posed);
  const std::vector<double> still(posture.size(), 0.0);
  std::vector<double> tau(posture.size());
  const Kinematics<double> now = placed(posed, posture);
  const Wrench<double> ground = inverse_dynamics<double>(posed, now, {still, still}, work, tau);
  if (posed.body.feet().size() == 2) {
    share_ground_wrench<double>(posed, now, {}, ground, tau);
  }
  double sum = 0.0;
  for (const int hip : back_constants(posed).dofs) sum += tau[static_cast<std::size_t>(hip)];
  return sum;
}

// The start posture with both hips flexed by that angle (rad).
std::vector<double> stoop(const PosedBody& posed, double flexion) {
  std::vector<double> q(posed.home.angles.begin(), posed.home.angles.end());
  for (const int hip : back_constants(posed).dofs) q[static_cast<std::size_t>(hip)] += flexion;
  return q;
}

TEST(LowBack, KnowsTheHips) {
  EXPECT_EQ(back_constants(half_body()).dofs.size(), 1u);
  EXPECT_EQ(back_constants(full_body()).dofs.size(), 2u);
}

TEST(LowBack, HipTorquesAreTheMomentOfAllAboveThem) {
  // the trunk and the arms, their weights' levers measured from the line through the hips; the half
  // body stands on straight feet, so its trunk leans in the plane of its one leg
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const std::vector<double> posture = stoop(posed, radians(70));
    const Kinematics<double> now = placed(posed, posture);
    const auto trunk = static_cast<std::size_t>(*posed.body.find_dof("right_hip.flexion"));
    double moment = 0.0;
    for (int link = 0; link < posed.body.dof_count(); ++link) {
      const std::string& joint = posed.body.dof(link).joint;
      const bool arm = joint.ends_with("shoulder") || joint.ends_with("elbow");
      if (!arm && static_cast<std::size_t>(link) != trunk) continue;
      const MassProperties& mass = posed.body.link_mass(link);
      moment += mass.mass * kGravity * (now.point(link, mass.com).z - now.origin[trunk].z);
    }
    ASSERT_GT(moment, 100.0);
    // lifting is extension
    EXPECT_NEAR(hip_torque(posed, posture), -moment, 0.02 * moment) << posed.body.name();
  }
}

TEST(LowBack, ShareIsThatOfDeLevasMasses) {
  // masses (of the body's) and heights above the hip joints (m), mean man: pelvis, middle trunk,
  // upper trunk, head with neck, and arms at their shoulders
  const std::vector<std::pair<double, double>> parts{
      {.1117, .0566}, {.1633, .2642}, {.1596, .4806}, {.0694, .7247}, {.0988, .5155}};
  const auto share = [&](double joint) {
    double hips = 0.0;
    double back = 0.0;
    for (const auto& [mass, height] : parts) {
      hips += mass * height;
      if (height > joint) back += mass * (height - joint);
    }
    return back / hips;
  };
  EXPECT_NEAR(share(0.10), kBackShareOfHips, 0.005);
  EXPECT_NEAR(share(0.07), 0.82, 0.005);
  EXPECT_NEAR(share(0.12), 0.71, 0.005);
}

TEST(LowBack, OfRestIsZero) { EXPECT_EQ(penalty_of(full_body(), {0, 0, 0}), 0.0); }

TEST(LowBack, IsTheSquareOfTheShareOfStrength) {
  // a mean man: 100 N·m about both hips, 76 about L5/S1
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const double r = 76.0 / 240.0;
    EXPECT_NEAR(penalty_of(posed, {-100}), r * r, 1e-12) << posed.body.name();
  }
}

TEST(LowBack, BendsForwardsWithLessStrength) {
  const double r = 38.0 / 150.0;
  EXPECT_NEAR(penalty_of(full_body(), {50}), r * r, 1e-12);
}

TEST(LowBack, IsHalfTheMeanAndHalfTheWorst) {
  const double once = penalty_of(full_body(), {-100});
  EXPECT_NEAR(penalty_of(full_body(), {0, -100, 0, 0}), once * (0.5 / 4 + 0.5), 1e-12);
}

TEST(LowBack, IsFullAtItsShareAndBeyond) {
  EXPECT_NEAR(penalty_of(full_body(), {-240.0 / 0.76}), 1.0, 1e-12);
  EXPECT_EQ(penalty_of(full_body(), {-1e5}), 1.0);
}

TEST(LowBack, StrengthFollowsTheBody) {
  // the same build at 0.8 of the stature: 0.64 of the mass and of the strength
  const PosedBody small = full_body({0.8 * 1.741, 0.64 * 73.0, Sex::male});
  EXPECT_NEAR(penalty_of(small, {-64}), penalty_of(full_body(), {-100}), 1e-12);
  const PosedBody woman = full_body({1.735, 61.9, Sex::female});
  EXPECT_NEAR(penalty_of(woman, {-60}), penalty_of(full_body(), {-100}), 1e-12);
}

TEST(LowBack, BearsHalfItsStrengthUnderAHorizontalTrunk) {
  // by de Leva's masses, for a mean man with hanging arms: 0.172 m of his weight
  const PosedBody posed = full_body();
  std::vector<double> posture = stoop(posed, radians(90));
  for (const char* shoulder : {"left_shoulder.flexion", "right_shoulder.flexion"}) {
    posture[static_cast<std::size_t>(*posed.body.find_dof(shoulder))] += radians(90);
  }
  const double torque = hip_torque(posed, posture);
  EXPECT_NEAR(-kBackShareOfHips * torque, 0.172 * 73.0 * kGravity, 8.0);
  EXPECT_NEAR(penalty_of(posed, {torque}), 0.5 * 0.5, 0.05);
}

TEST(LowBack, ShareIsASetting) {
  EXPECT_NEAR(penalty_of(full_body(), {-50}, 2.0), 0.25 * penalty_of(full_body(), {-50}), 1e-12);
}

TEST(LowBack, OfABodyWithoutHipsIsZero) {
  const PosedBody posed = chain({{}});
  Motion motion = motion_through(posed, {{0.5}});
  motion.torques = {100.0};
  EXPECT_EQ(penalty_by<LowBack>(posed, motion), 0.0);
}

}  // namespace
}  // namespace shigusa
