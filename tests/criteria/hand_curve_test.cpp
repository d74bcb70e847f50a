// SPDX-License-Identifier: MIT
#include "criteria/hand_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/minimum_jerk.hpp"
#include "support/posed_body.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kFrom{-0.2, 1.0, 0.1};
constexpr Vec3d kForwards{0, 0, 1};
constexpr Vec3d kOutwards{-1, 0, 0};
constexpr Vec3d kUp{0, 1, 0};

// Of the two spans between three frames, the middle frame counts as half of each: the mean over
// time is this share of its value.
constexpr double kMiddleShare = 0.5;

// The right hand moves by `way` (m) in three frames, and in the middle one is off its line by a
// vector such that its mean offset is that of a bow of `off` (of the path's length).
std::vector<Pose> going(const Vec3d& way, const Vec3d& off = {}) {
  std::vector<Pose> poses(3);
  poses[0].right.hand = kFrom;
  poses[1].right.hand = kFrom + way * 0.5 + off * (kMeanBow / kMiddleShare * norm(way));
  poses[2].right.hand = kFrom + way;
  return poses;
}

double penalty_of(const std::vector<Pose>& poses, double offset = kPathOffset) {
  return penalty_of_poses<HandCurve>(poses,
                                     {.scale = offset, .effectors = right_hand_of(posed_body())});
}

// The penalty where the mean square deviation from people's paths is that many squares of the
// offset.
double penalty_for(double squares) { return squares / (1.0 + squares); }

// The penalty of a hand that deviates from people's path by that share of its length.
double cost_of(double off) { return penalty_for(off * off / (kPathOffset * kPathOffset)); }

TEST(HandCurve, MeanOfABowIsThatOfTheMinimumJerkProfile) {
  constexpr int kSteps = 10000;
  double sum = 0.0;
  for (int f = 0; f < kSteps; ++f) sum += path_bow(minimum_jerk((f + 0.5) / kSteps), 0.0);
  EXPECT_NEAR(kMeanBow, sum / kSteps, 1e-4);
}

// The right hand moves by `way` (m) as people's hands do, and leaves its line by a bow of `off` (of
// the path's length).
std::vector<Pose> bowing(const Vec3d& way, const Vec3d& off, int frames) {
  std::vector<Pose> poses;
  for (int f = 0; f < frames; ++f) {
    const double done = minimum_jerk(static_cast<double>(f) / (frames - 1));
    Pose pose;
    pose.right.hand = kFrom + way * done + off * (path_bow(done, 0.0) * norm(way));
    poses.push_back(pose);
  }
  return poses;
}

TEST(HandCurve, OfABowIsTheSameInFewFramesAndInMany) {
  constexpr double kBow = 0.1;
  for (const int frames : {15, 30, 300}) {
    EXPECT_NEAR(penalty_of(bowing({0, 0, 0.4}, kOutwards * kBow, frames)), cost_of(kBow), 1e-4)
        << frames;
  }
}

// A hand's positions at both ends count for half a frame each.
TEST(HandCurve, IsTheMeanOverTimeNotOverFrames) {
  constexpr double kBow = 0.1;
  const Vec3d way{0, 0, 0.4};
  const Vec3d off = kOutwards * (kMeanBow * norm(way) * kBow);
  // off by as much in two frames of four, which are two thirds of the time
  std::vector<Pose> poses(4);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    poses[f].right.hand = kFrom + way * (static_cast<double>(f) / 3.0);
    if (f == 1 || f == 2) poses[f].right.hand += off * 1.5;
  }
  EXPECT_NEAR(penalty_of(poses), cost_of(kBow), 1e-12);
}

TEST(HandCurve, OfPeoplesWaysIsZero) {
  EXPECT_NEAR(penalty_of(going({-0.4, 0, 0}, kForwards * kBowLevel)), 0.0, 1e-12);
  EXPECT_NEAR(penalty_of(going({0, -0.4, 0}, kForwards * (kBowLevel + kBowDown))), 0.0, 1e-12);
  EXPECT_NEAR(penalty_of(going({0, 0.4, 0}, kForwards * (kBowLevel - kBowDown))), 0.0, 1e-12);
}

TEST(HandCurve, OfAWayThatGoesDownAndForwardsBowsSquareToIt) {
  const double slant = std::sqrt(0.5);
  const Vec3d way{0, -0.4 * slant, 0.4 * slant};
  // of the forwards direction, the part that is square to the way
  const Vec3d bow = Vec3d{0, slant, slant} * slant;
  EXPECT_NEAR(penalty_of(going(way, bow * (kBowLevel + kBowDown * slant))), 0.0, 1e-12);
}

TEST(HandCurve, IsTheSquareOfTheOffsetInAnyDirection) {
  const Vec3d way{0, -0.4, 0};
  const Vec3d peoples = kForwards * (kBowLevel + kBowDown);
  for (const Vec3d& off : {kForwards * 0.05, kForwards * -0.05, kOutwards * 0.05, kOutwards * -0.05,
                           kOutwards * 0.03 + kForwards * 0.04}) {
    EXPECT_NEAR(penalty_of(going(way, peoples + off)), cost_of(0.05), 1e-12);
  }
}

TEST(HandCurve, OfAStraightWayIsWhatPeoplesBowIs) {
  EXPECT_NEAR(penalty_of(going({-0.4, 0, 0})), cost_of(kBowLevel), 1e-12);
}

TEST(HandCurve, WhenTheHandIsWhereOnItsWayDoesNotMatter) {
  const double straight = penalty_of(going({-0.4, 0, 0}));
  EXPECT_NEAR(penalty_of(going({-0.4, 0, 0}, kOutwards * 0.2)), straight, 1e-12);
}

TEST(HandCurve, OfAWayTwiceAsLongIsTheSame) {
  const Vec3d off = kOutwards * 0.05 + kUp * 0.02;
  EXPECT_NEAR(penalty_of(going({0.1, -0.3, 0.2}, off)), penalty_of(going({0.2, -0.6, 0.4}, off)),
              1e-12);
}

TEST(HandCurve, OfAHandThatHardlyMovesIsZero) {
  EXPECT_EQ(penalty_of(going({0, 0.049, 0}, kOutwards)), 0.0);
  EXPECT_GT(penalty_of(going({0, 0.051, 0}, kOutwards)), 0.9);
  EXPECT_EQ(penalty_of(going({}, kOutwards)), 0.0);
  EXPECT_EQ(penalty_of({going({})[0]}), 0.0);
}

TEST(HandCurve, IsTheMeanOverTheHands) {
  std::vector<Pose> poses = going({-0.4, 0, 0}, kForwards * (kBowLevel + 0.1));
  // the other hand's way is people's
  for (std::size_t f = 0; f < poses.size(); ++f) {
    poses[f].left.hand = kFrom + Vec3d{0, 0, 0.2 * static_cast<double>(f)};
  }
  EXPECT_NEAR(penalty_of_poses<HandCurve>(poses),
              penalty_for(0.5 * 0.1 * 0.1 / (kPathOffset * kPathOffset)), 1e-12);
  EXPECT_NEAR(penalty_of(poses), cost_of(0.1), 1e-12);
}

TEST(HandCurve, NearerIsBetterHoweverFarItIs) {
  double before = -1.0;
  for (double off = 0.0; off < 5.0 * kPathOffset; off += 0.01) {
    const double now = penalty_of(going({0, 0, 0.4}, kOutwards * off));
    EXPECT_NEAR(now, cost_of(off), 1e-12);
    EXPECT_GT(now, before);
    EXPECT_LT(now, 1.0);
    before = now;
  }
}

TEST(HandCurve, OffsetIsASetting) {
  EXPECT_NEAR(penalty_of(going({0, 0, 0.4}, kOutwards * 0.1), 0.4), penalty_for(0.0625), 1e-12);
}

TEST(HandCurve, IsTheSameInAMirror) { expect_the_same_in_a_mirror<HandCurve>({.scale = 1.0}); }

TEST(HandCurve, OfABodyWithoutHandsIsZero) {
  BodyDefinition handless = posed_definition();
  handless.effectors[0].name = "left_foot";
  handless.effectors[1].name = "right_foot";
  EXPECT_EQ(penalty_of_poses<HandCurve>(going({0, 0, 0.4}, kOutwards), {}, at_zero(handless)), 0.0);
}

}  // namespace
}  // namespace shigusa
