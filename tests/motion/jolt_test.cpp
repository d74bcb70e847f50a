// SPDX-License-Identifier: MIT
#include "motion/jolt.hpp"

#include <gtest/gtest.h>

namespace shigusa {
namespace {

// Frames of three evenly moving dofs, one of which is displaced by `by` (rad) in a frame.
Clip stepping(int frames, int frame, int dof, double by) {
  Clip clip{.dofs = 3, .frames = frames, .angles = {}};
  for (int f = 0; f < frames; ++f) {
    for (int d = 0; d < 3; ++d) {
      clip.angles.push_back((d + 1) * 0.5 * f + (f == frame && d == dof ? by : 0.0));
    }
  }
  return clip;
}

TEST(Jolts, EvenStepsOfAnySizeAreNone) { EXPECT_FALSE(jolts(stepping(6, 0, 0, 0.0))); }

TEST(Jolts, AnyJointMayInAnyFrame) {
  for (int frame = 0; frame < 6; ++frame) {
    for (int dof = 0; dof < 3; ++dof) {
      for (const double side : {-1.0, 1.0}) {
        // the frame itself changes by twice as much, its neighbours by once
        const double least = (frame == 0 || frame == 5 ? 1.0 : 0.5) * side * kJolt;
        EXPECT_TRUE(jolts(stepping(6, frame, dof, 1.01 * least))) << frame << ' ' << dof;
        EXPECT_FALSE(jolts(stepping(6, frame, dof, 0.99 * least))) << frame << ' ' << dof;
      }
    }
  }
}

TEST(Jolts, TwoFramesHaveNoStepThatChanges) {
  EXPECT_FALSE(jolts(stepping(2, 1, 0, 1.0)));
  EXPECT_FALSE(jolts(Clip{}));
}

}  // namespace
}  // namespace shigusa
