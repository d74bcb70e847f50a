// SPDX-License-Identifier: MIT
#include "criteria/joint_acceleration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/minimum_jerk.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kRate = 60.0;  // 1/s, of motion_through

PosedBody hinges(int count) {
  return chain(std::vector<Pendulum>(static_cast<std::size_t>(count)));
}

// The penalty of one hinge with these angles, frame by frame.
double penalty_of(const std::vector<double>& angles, double scale = kJointAcceleration) {
  std::vector<std::vector<double>> frames;
  for (const double angle : angles) frames.push_back({angle});
  return penalty_by<JointAcceleration>(hinges(1), motion_through(hinges(1), frames), scale);
}

TEST(JointAcceleration, OfRestIsZero) { EXPECT_EQ(penalty_of({0.3, 0.3, 0.3}), 0.0); }

TEST(JointAcceleration, OfConstantSpeedIsWhatItTakesToStartAndToStop) {
  // 1e-4 rad a frame: only the first and the last of five frames are accelerated
  const double jolt = 1e-4 * kRate * kRate;
  EXPECT_NEAR(penalty_of({0, 1e-4, 2e-4, 3e-4, 4e-4}),
              std::sqrt(2.0 / 5.0) * jolt / kJointAcceleration, 1e-12);
}

TEST(JointAcceleration, OfUniformAccelerationIsItsShare) {
  // angles with the second difference a / rate²; a long motion hides its ends
  const double a = 2.0;
  std::vector<double> angles;
  for (int f = 0; f <= 40; ++f) angles.push_back(0.5 * a * f * f / (kRate * kRate));
  // the first frame's difference is half as large, the last one stops all speed
  const double stop = a * 39.5;
  const double squares = 39 * a * a + 0.25 * a * a + stop * stop;
  EXPECT_NEAR(penalty_of(angles, 100.0), std::sqrt(squares / 41) / 100.0, 1e-9);
}

TEST(JointAcceleration, IsFullForATurnBy90DegreesInOneSecond) {
  std::vector<double> angles;
  for (int f = 0; f <= 60; ++f) angles.push_back(kPi / 2 * minimum_jerk(f / kRate));
  // the closed form sqrt(120 / 7) · π / 2 over 6.5, approximated by 60 steps
  EXPECT_NEAR(penalty_of(angles, 2 * kJointAcceleration), 0.5, 0.01);
  EXPECT_NEAR(std::sqrt(120.0 / 7.0) * kPi / 2, kJointAcceleration, 0.01);
}

TEST(JointAcceleration, IsTheRootMeanSquareOverJoints) {
  const Motion one = motion_through(hinges(1), {{0.0}, {1e-4}, {0.0}});
  const Motion of_four = motion_through(hinges(4), {{0, 0, 0, 0}, {0, 1e-4, 0, 0}, {0, 0, 0, 0}});
  EXPECT_NEAR(penalty_by<JointAcceleration>(hinges(4), of_four),
              0.5 * penalty_by<JointAcceleration>(hinges(1), one), 1e-12);
}

TEST(JointAcceleration, FallsWithTheSquareOfTheTimeTaken) {
  Motion motion = motion_through(hinges(1), {{0.0}, {1e-4}, {0.0}});
  const double before = penalty_by<JointAcceleration>(hinges(1), motion);
  motion.clip.frame_time *= 2.0;
  EXPECT_NEAR(penalty_by<JointAcceleration>(hinges(1), motion), before / 4.0, 1e-12);
}

TEST(JointAcceleration, IsFullBeyondItsScale) { EXPECT_EQ(penalty_of({0.0, 1.0, -1.0}), 1.0); }

}  // namespace
}  // namespace shigusa
