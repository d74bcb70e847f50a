// SPDX-License-Identifier: MIT
#include "motion/low_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/math.hpp>

namespace shigusa {
namespace {

constexpr double kRate = 60.0;
constexpr double kCutoff = 6.0;

template <class Function>
Clip clip_of(int frames, const Function& angle) {
  Clip clip{.dofs = 2, .frames = frames, .frame_time = 1.0 / kRate, .angles = {}};
  for (int f = 0; f < frames; ++f) {
    clip.angles.push_back(angle(f / kRate));
    clip.angles.push_back(7.0);
  }
  return clip;
}

// Amplitude of a wave of this frequency (Hz) in the middle of a long clip.
double gain(double hertz) {
  Clip clip = clip_of(600, [&](double t) { return std::sin(2.0 * kPi * hertz * t); });
  low_pass(clip, kCutoff);
  double squares = 0.0;
  for (int f = 180; f < 420; ++f) squares += clip.frame(f)[0] * clip.frame(f)[0];
  return std::sqrt(squares / 120.0);
}

TEST(LowPass, LeavesAConstantAndASteadyTurnAsTheyAre) {
  const Clip before = clip_of(50, [](double t) { return 0.3 + 2.0 * t; });
  Clip clip = before;
  low_pass(clip, kCutoff);
  for (std::size_t i = 0; i < clip.angles.size(); ++i) {
    // the filter's own state settles by e^-2π·2 of the turn in the frames before
    EXPECT_NEAR(clip.angles[i], before.angles[i], 1e-4);
  }
}

// Winter's equations: |H|² of both passes together is a half at the cutoff.
TEST(LowPass, HalvesThePowerAtTheCutoff) {
  EXPECT_NEAR(gain(kCutoff) * gain(kCutoff), 0.5, 1e-6);
  EXPECT_NEAR(gain(1.0), 1.0, 0.001);
  EXPECT_LT(gain(20.0), 0.01);
}

TEST(LowPass, DelaysNothing) {
  const auto bump = [](double t) { return std::exp(-50.0 * (t - 1.0) * (t - 1.0)); };
  Clip clip = clip_of(121, bump);
  low_pass(clip, kCutoff);
  for (int f = 1; f <= 60; ++f) {
    EXPECT_NEAR(clip.frame(60 - f)[0], clip.frame(60 + f)[0], 1e-6);
  }
}

TEST(LowPass, LeavesWhatIsTooShortOrTooSlow) {
  const Clip two = clip_of(2, [](double t) { return t; });
  Clip clip = two;
  low_pass(clip, kCutoff);
  EXPECT_EQ(clip.angles, two.angles);
  const Clip jump = clip_of(20, [](double t) { return t > 0.15 ? 1.0 : 0.0; });
  clip = jump;
  low_pass(clip, kLowPassShare * kRate);
  EXPECT_EQ(clip.angles, jump.angles);
}

}  // namespace
}  // namespace shigusa
