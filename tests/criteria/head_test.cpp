// SPDX-License-Identifier: MIT
#include "criteria/head.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

const PosedBody& body() {
  static const PosedBody posed = half_body();
  return posed;
}

// The start posture with the hip flexed further by `lean` (rad): the trunk leans by as much.
std::vector<double> leaning(double lean) {
  std::vector<double> q(body().home.angles.begin(), body().home.angles.end());
  q[static_cast<std::size_t>(*body().body.find_dof("right_hip.flexion"))] += lean;
  return q;
}

double penalty_of(const std::vector<double>& leans, const CriteriaContext& context = {},
                  double height = kHeadHeight) {
  std::vector<std::vector<double>> frames;
  for (const double lean : leans) frames.push_back(leaning(lean));
  return penalty_by<Head>(body(), motion_through(body(), frames), height, context);
}

Vec3d node_at(const char* name, double lean) {
  const Kinematics<double> now = placed(body(), leaning(lean));
  for (const BodyNode& node : body().body.nodes()) {
    if (node.name == name) return now.point(node.link, node.point);
  }
  ADD_FAILURE() << "no node " << name;
  return {};
}

// A goal at this angle to the left of straight ahead (rad), seen from the upright head.
Vec3d to_the_left(double angle) {
  return node_at("head", 0.0) + Vec3d{std::sin(angle), 0.0, std::cos(angle)} * 0.7;
}

TEST(Head, OfUprightStandingIsZero) {
  EXPECT_EQ(penalty_of({0.0}), 0.0);
  EXPECT_EQ(penalty_of({0.0}, {.gaze = Vec3d{0.1, 1.2, 0.6}}), 0.0);
}

TEST(Head, OfUprightStandingSeesTheFloorAheadOfTheFeet) {
  EXPECT_EQ(penalty_of({0.0}, {.gaze = Vec3d{0.1, 0.0, 0.4}}), 0.0);
}

TEST(Head, MayLeanBy60Degrees) {
  EXPECT_EQ(penalty_of({radians(50)}), 0.0);
  EXPECT_NEAR(penalty_of({radians(60)}), 0.0, 0.02);
  EXPECT_GT(penalty_of({radians(65)}), 0.1);
}

TEST(Head, IsWhatTheHeightLacks) {
  const double lean = radians(75);
  const Vec3d way = node_at("head", lean) - node_at("hips", lean);
  EXPECT_NEAR(penalty_of({lean}), 1.0 - way.y / (0.5 * norm(way)), 1e-12);
}

TEST(Head, BelowThePelvisIsFull) {
  EXPECT_EQ(penalty_of({radians(95)}), 1.0);
  EXPECT_EQ(penalty_of({radians(110)}), 1.0);
}

TEST(Head, NeverFallsWithMoreLean) {
  double before = 0.0;
  for (double lean = 0.0; lean < 2.0; lean += 0.02) {
    const double now = penalty_of({0.0, lean});
    EXPECT_GE(now, before - 1e-15);
    before = now;
  }
}

TEST(Head, IsHalfTheMeanAndHalfTheWorst) {
  const double once = penalty_of({radians(75)});
  EXPECT_NEAR(penalty_of({0.0, radians(75), 0.0, 0.0}), once * (0.5 / 4 + 0.5), 1e-12);
}

TEST(Head, NeckAndEyesTurnToTheSideBy80Degrees) {
  EXPECT_EQ(penalty_of({0.0}, {.gaze = to_the_left(radians(79))}), 0.0);
  EXPECT_EQ(penalty_of({0.0}, {.gaze = to_the_left(radians(-79))}), 0.0);
  EXPECT_NEAR(penalty_of({0.0}, {.gaze = to_the_left(kGazeFree)}), 0.0, 1e-12);
}

TEST(Head, AndNotByMoreThan95) {
  EXPECT_NEAR(penalty_of({0.0}, {.gaze = to_the_left(kGazeLimit)}), 1.0, 1e-12);
  EXPECT_EQ(penalty_of({0.0}, {.gaze = to_the_left(radians(140))}), 1.0);
  const double between =
      (std::cos(kGazeFree) - std::cos(radians(88))) / (std::cos(kGazeFree) - std::cos(kGazeLimit));
  EXPECT_NEAR(penalty_of({0.0}, {.gaze = to_the_left(radians(88))}), between, 1e-12);
}

TEST(Head, CountsTheWorseOfHeightAndGaze) {
  const Vec3d behind{0.0, 1.0, -1.0};
  EXPECT_EQ(penalty_of({0.0}, {.gaze = behind}), 1.0);
  // a goal on the floor does not make up for a head that hangs
  EXPECT_EQ(penalty_of({radians(110)}, {.gaze = Vec3d{0.0, 0.0, 0.5}}), 1.0);
}

TEST(Head, TurnsWithTheTrunk) {
  // looking at a goal behind takes a turn of the hips, however small
  const Vec3d aside = to_the_left(radians(100));
  std::vector<double> turned(body().home.angles.begin(), body().home.angles.end());
  turned[static_cast<std::size_t>(*body().body.find_dof("right_hip.rotation"))] += radians(30);
  const double turned_away =
      penalty_by<Head>(body(), motion_through(body(), {turned}), {.gaze = aside});
  turned[static_cast<std::size_t>(*body().body.find_dof("right_hip.rotation"))] -= radians(60);
  const double turned_to =
      penalty_by<Head>(body(), motion_through(body(), {turned}), {.gaze = aside});
  EXPECT_EQ(max(turned_away, turned_to), 1.0);
  EXPECT_EQ(min(turned_away, turned_to), 0.0);
}

TEST(Head, AGoalInTheHeadItselfIsANumber) {
  EXPECT_TRUE(std::isfinite(penalty_of({0.0}, {.gaze = node_at("head", 0.0)})));
}

TEST(Head, HeightIsASetting) { EXPECT_GT(penalty_of({radians(50)}, {}, 0.9), 0.2); }

TEST(Head, OfABodyWithoutOneIsZero) {
  const PosedBody rod = chain({{}});
  EXPECT_EQ(penalty_by<Head>(rod, motion_through(rod, {{1.8}}), {.gaze = Vec3d{0, 0, -5}}), 0.0);
}

}  // namespace
}  // namespace shigusa
