// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/motion.hpp>

#include "core/check.hpp"
#include "motion/minimum_jerk.hpp"

namespace shigusa {
namespace {

constexpr int kFrames = 61;  // of the kernel's motions

// Turns by a radian with minimum jerk, and back with another dof.
Clip reach(double duration) {
  Clip clip{.dofs = 2, .frames = kFrames, .frame_time = duration / (kFrames - 1), .angles = {}};
  for (int f = 0; f < kFrames; ++f) {
    const double s = minimum_jerk(static_cast<double>(f) / (kFrames - 1));
    clip.angles.insert(clip.angles.end(), {s, 1.0 - s});
  }
  return clip;
}

TEST(FramesAt, TheLastIsTheFirstThatIsNotBeforeTheEnd) {
  EXPECT_EQ(frames_at(1.0, 60.0), 61);
  EXPECT_EQ(frames_at(1.001, 60.0), 62);
  EXPECT_EQ(frames_at(0.999, 60.0), 61);
  EXPECT_EQ(frames_at(1.0, 29.97), 31);
  EXPECT_EQ(frames_at(0.6, 1.0), 2);
  EXPECT_EQ(frames_at(0.0, 60.0), 1);
}

TEST(FramesAt, RoundingMakesNoFrame) {
  for (int frames = 1; frames < 2000; ++frames) {
    for (const double rate : {1.0, 24.0, 29.97, 30.0, 60.0, 119.88, 240.0}) {
      EXPECT_EQ(frames_at(frames / rate, rate), frames + 1) << frames << " at " << rate;
    }
  }
}

TEST(Resampled, OfTheClipsOwnRateIsTheClip) {
  const Clip clip = reach(1.0);
  const Clip same = resampled(clip, 60.0);
  EXPECT_EQ(same.frames, clip.frames);
  EXPECT_EQ(same.angles, clip.angles);
}

TEST(Resampled, KeepsTheFramesThatBothHave) {
  const Clip clip = reach(1.0);
  const Clip slow = resampled(clip, 30.0);
  const Clip fast = resampled(clip, 120.0);
  for (int f = 0; f < slow.frames; ++f) EXPECT_EQ(slow.frame(f)[0], clip.frame(2 * f)[0]);
  for (int f = 0; f < clip.frames; ++f) EXPECT_EQ(fast.frame(2 * f)[0], clip.frame(f)[0]);
}

TEST(Resampled, KeepsTheVelocitiesOfAMovingStart) {
  Clip clip = reach(1.0);
  const double velocities[] = {0.4, -1.2};  // rad/s
  for (int f = 0; f < kFrames; ++f) {
    for (std::size_t d = 0; d < 2; ++d) {
      clip.angles[2 * static_cast<std::size_t>(f) + d] +=
          velocities[d] * carried_on(static_cast<double>(f) / (kFrames - 1));
    }
  }
  for (std::size_t d = 0; d < 2; ++d) {
    clip.before.push_back(clip.frame(0)[d] - velocities[d] * clip.frame_time);
  }
  for (const double rate : {24.0, 60.0, 120.0}) {
    const State state = resampled(clip, rate).state(0);
    ASSERT_EQ(state.velocities.size(), 2u);
    // within the curve's third derivative times a sixth of the squared frame time
    const double slack = 72.0 / (6.0 * rate * rate) * 1.2 + 60.0 / (6.0 * rate * rate);
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_NEAR(state.velocities[d], velocities[d], slack) << rate;
    }
  }
}

TEST(ClipState, HasVelocitiesWhereTheClipMoves) {
  const Clip clip = reach(1.0);
  EXPECT_TRUE(clip.state(0).velocities.empty());
  EXPECT_TRUE(clip.state(clip.frames - 1).velocities.empty());
  const State middle = clip.state(clip.frames / 2);
  EXPECT_EQ(middle.angles[0], 0.5);
  // 15/8 of the mean velocity, by differences over 1/30 s
  EXPECT_NEAR(middle.velocities[0], 1.875, 2e-3);
  EXPECT_NEAR(middle.velocities[1], -1.875, 2e-3);
}

TEST(Resampled, EndsWithTheClipsLastPosture) {
  for (const double duration : {0.6, 1.088, 2.14}) {
    const Clip clip = reach(duration);
    for (const double rate : {1.0, 24.0, 25.0, 29.97, 30.0, 60.0, 120.0, 240.0}) {
      const Clip other = resampled(clip, rate);
      EXPECT_EQ(other.frames, frames_at(duration, rate));
      EXPECT_EQ(other.frame_time, 1.0 / rate);
      EXPECT_GE(other.duration(), duration - 1e-9);
      EXPECT_LT(other.duration(), duration + 1.0 / rate);
      EXPECT_EQ(other.frame(0)[0], 0.0);
      EXPECT_EQ(other.frame(other.frames - 1)[0], 1.0);
      EXPECT_EQ(other.frame(other.frames - 1)[1], 0.0);
    }
  }
}

// |d³s/dτ³| of the minimum-jerk profile is 60 at most, so with 60 steps the error of a radian is at
// most 60 / 60³ / 40.
TEST(Resampled, IsTheMotionBetweenFramesToo) {
  const double duration = 1.088;
  const double most = 60.0 / 60.0 / 60.0 / 60.0 / 40.0;
  for (const double rate : {24.0, 29.97, 60.0, 240.0}) {
    const Clip other = resampled(reach(duration), rate);
    for (int f = 0; f < other.frames; ++f) {
      EXPECT_NEAR(other.frame(f)[0], minimum_jerk(f / rate / duration), most) << f;
    }
  }
}

TEST(Resampled, ARateThatIsNoneIsACallersMistake) {
  for (const double rate : {0.0, -1.0, 241.0, std::nan("")}) {
    EXPECT_THROW((void)resampled(reach(1.0), rate), PreconditionError);
  }
}

}  // namespace
}  // namespace shigusa
