// SPDX-License-Identifier: MIT
#include "paper/arm_swivel.hpp"

#include <gtest/gtest.h>

#include "motion/minimum_jerk.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr int kFrames = 61;

// An arm alone, with everything needed to measure its motion.
struct Arm {
  explicit Arm(const PosedBody& posed, std::size_t index = 0)
      : limb(find_limbs(posed.body, posed.home).value().arms[index]),
        model(arm_body(posed.body, posed.home, limb)) {}

  [[nodiscard]] Vec3d hand(std::span<const double> q) const {
    return effector_position(model, q, model.body.effectors()[0].name.c_str());
  }
  [[nodiscard]] Vec3d elbow(std::span<const double> q) const { return placed(model, q).origin[3]; }
  // minimum jerk along a straight line from where the hand hangs
  [[nodiscard]] std::vector<Vec3d> way_to(const Vec3d& goal) const {
    const Vec3d from = hand(model.home.angles);
    std::vector<Vec3d> path;
    for (int f = 0; f < kFrames; ++f) {
      path.push_back(from + (goal - from) * minimum_jerk(f / (kFrames - 1.0)));
    }
    return path;
  }
  [[nodiscard]] std::vector<double> moved(std::span<const Vec3d> path, double swivel) const {
    std::vector<double> angles;
    SwivelArm<double> arm(model, limb);
    arm.follow(path);
    EXPECT_LT(arm.run(swivel, angles), 1e-9);
    EXPECT_EQ(angles.size(), path.size() * kArmDofs);
    return angles;
  }
  [[nodiscard]] static std::span<const double> frame(const std::vector<double>& angles, int f) {
    return std::span(angles).subspan(static_cast<std::size_t>(f) * kArmDofs, kArmDofs);
  }

  BodyLimb limb;
  PosedBody model;
};

// A goal that the arm reaches on a straight path, all of which is within reach.
Vec3d arm_goal(const Arm& arm, Random& random) {
  const Vec3d from = arm.hand(arm.model.home.angles);
  for (;;) {
    const Vec3d goal = random_direction(random) * random.uniform(0.2, 0.6);
    const Vec3d way = goal - from;
    const double nearest = clamp(dot(-from, way) / dot(way, way), 0.0, 1.0);
    if (norm(from + way * nearest) > 0.2) return goal;
  }
}

TEST(SwivelArm, FollowsItsPathWithAnySwivel) {
  Random random(1);
  for (const PosedBody& posed :
       {full_body(), build_human(asymmetric_person(), {"crooked", BodyExtent::full, 1.6, 60.0})}) {
    for (const std::size_t side : {0u, 1u}) {
      const Arm arm(posed, side);
      for (int i = 0; i < 50; ++i) {
        const std::vector<Vec3d> path = arm.way_to(arm_goal(arm, random));
        const auto angles = arm.moved(path, random.uniform(-1.5, 1.5));
        for (int f = 1; f < kFrames; ++f) {
          EXPECT_LT(norm(arm.hand(Arm::frame(angles, f)) - path[static_cast<std::size_t>(f)]),
                    1e-9);
        }
        for (std::size_t d = 0; d < kArmDofs; ++d) EXPECT_EQ(angles[d], arm.model.home.angles[d]);
      }
    }
  }
}

// Angle (rad) between two elbows about the line from shoulder to hand, right-handed.
double between(const Vec3d& hand, const Vec3d& from, const Vec3d& to) {
  const Vec3d along = normalized(hand);
  const Vec3d a = from - along * dot(from, along);
  const Vec3d b = to - along * dot(to, along);
  return atan2(dot(cross(a, b), along), dot(a, b));
}

TEST(SwivelArm, TurnsTheElbowByTheSwivelOutwards) {
  Random random(2);
  for (const std::size_t side : {0u, 1u}) {
    const Arm arm(full_body(), side);
    const double outwards = arm.limb.name == "right_arm" ? -1.0 : 1.0;
    for (int i = 0; i < 50; ++i) {
      const std::vector<Vec3d> path = arm.way_to(arm_goal(arm, random));
      const double swivel = random.uniform(-1.2, 1.2);
      const auto without = arm.moved(path, 0.0);
      const auto with = arm.moved(path, swivel);
      for (const int f : {15, 30, 60}) {
        const double turned =
            between(path[static_cast<std::size_t>(f)], arm.elbow(Arm::frame(without, f)),
                    arm.elbow(Arm::frame(with, f)));
        EXPECT_NEAR(turned, outwards * swivel * minimum_jerk(f / 60.0), 1e-9);
      }
    }
  }
  // in front, outwards is to the side and up
  const Arm arm(full_body());
  const auto front = arm.way_to({0.0, 0.0, 0.45});
  const Vec3d down = arm.elbow(Arm::frame(arm.moved(front, 0.0), 60));
  const Vec3d out = arm.elbow(Arm::frame(arm.moved(front, 1.0), 60));
  EXPECT_LT(out.x, down.x - 0.05);
  EXPECT_GT(out.y, down.y + 0.02);
}

// A hand on a minimum-jerk line of 1.3 m moves by at most 41 mm per frame, and turns its arm by
// that over the least distance, 0.2 m.
TEST(SwivelArm, ElbowGoesOnEvenlyOnAnyWay) {
  Random random(3);
  const Arm arm(full_body());
  for (int i = 0; i < 200; ++i) {
    const auto angles = arm.moved(arm.way_to(arm_goal(arm, random)), random.uniform(-1.0, 1.5));
    for (int f = 1; f < kFrames; ++f) {
      const Vec3d step = arm.elbow(Arm::frame(angles, f)) - arm.elbow(Arm::frame(angles, f - 1));
      EXPECT_LT(norm(step), 0.08) << i << " at frame " << f;
    }
  }
}

TEST(SwivelArm, HangingArmSwivelsInPlace) {
  const Arm arm(full_body());
  const std::vector<Vec3d> path(kFrames, arm.hand(arm.model.home.angles));
  const auto angles = arm.moved(path, radians(60.0));
  for (int f = 1; f < kFrames; ++f) {
    for (std::size_t d = 0; d < kArmDofs; ++d) {
      EXPECT_LT(abs(Arm::frame(angles, f)[d] - Arm::frame(angles, f - 1)[d]), radians(3.0));
    }
  }
  EXPECT_NEAR(Arm::frame(angles, 60)[3], arm.model.home.angles[3], 1e-6);
}

TEST(SwivelArm, TellsWhatIsMissedBeyondItsLength) {
  const Arm arm(full_body());
  const double longest = arm.limb.segments.longest();
  std::vector<double> angles;
  SwivelArm<double> moved(arm.model, arm.limb);
  moved.follow(arm.way_to({0.0, 0.0, longest + 0.1}));
  EXPECT_NEAR(moved.run(0.0, angles), 0.1, 1e-3);
  // through the shoulder itself
  const Vec3d from = arm.hand(arm.model.home.angles);
  moved.follow(arm.way_to(-from));
  EXPECT_LT(moved.run(0.5, angles), 1.0);
  for (const double angle : angles) EXPECT_TRUE(std::isfinite(angle));
}

}  // namespace
}  // namespace shigusa
