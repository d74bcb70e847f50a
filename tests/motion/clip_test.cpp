// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/motion.hpp>

namespace shigusa {
namespace {

TEST(Clip, FramesFollowEachOther) {
  const Clip clip{.dofs = 2, .frames = 3, .frame_time = 0.5, .angles = {0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(clip.frame(1)[0], 2.0);
  EXPECT_EQ(clip.frame(2)[1], 5.0);
  EXPECT_EQ(clip.frame(2).size(), 2u);
}

TEST(Clip, LastsFromItsFirstFrameToItsLast) {
  EXPECT_EQ((Clip{.dofs = 1, .frames = 3, .frame_time = 0.5, .angles = {0, 1, 2}}.duration()), 1.0);
  EXPECT_EQ((Clip{.dofs = 1, .frames = 1, .frame_time = 0.5, .angles = {0}}.duration()), 0.0);
  EXPECT_EQ(Clip{}.duration(), 0.0);
}

}  // namespace
}  // namespace shigusa
