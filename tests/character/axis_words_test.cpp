// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/goal.hpp>
#include <shigusa/math.hpp>

namespace shigusa {
namespace {

TEST(AxisWords, OfAHangingHandPointInAheadAndDown) {
  for (const char* hand : {"left_hand", "right_hand", "left_wrist", "right_wrist"}) {
    for (const auto& [axis, direction] :
         {std::pair{"palm", "in"}, {"thumb", "ahead"}, {"fingers", "down"}}) {
      EXPECT_EQ(hand_axis(axis, hand).value(), direction_named(direction, hand).value()) << hand;
    }
  }
  EXPECT_FALSE(hand_axis("palm", "head"));
  EXPECT_FALSE(hand_axis("nail", "left_hand"));
}

TEST(AxisWords, DirectionsAreThoseOfTheWorldAndOfTheSide) {
  const auto way = [](const char* word, const char* hand = "") {
    return direction_named(word, hand).value();
  };
  EXPECT_EQ(way("left"), (Vec3d{1, 0, 0}));
  EXPECT_EQ(way("up"), (Vec3d{0, 1, 0}));
  EXPECT_EQ(way("ahead"), (Vec3d{0, 0, 1}));
  EXPECT_EQ(way("right"), -way("left"));
  EXPECT_EQ(way("down"), -way("up"));
  EXPECT_EQ(way("back"), -way("ahead"));
  for (const char* of : {"hand", "wrist"}) {
    const std::string left = std::string("left_") + of;
    const std::string right = std::string("right_") + of;
    EXPECT_EQ(way("in", right.c_str()), way("left"));
    EXPECT_EQ(way("in", left.c_str()), way("right"));
    EXPECT_EQ(way("out", left.c_str()), way("left"));
    EXPECT_EQ(way("ahead", left.c_str()), way("ahead"));
  }
  EXPECT_FALSE(direction_named("north", "left_hand"));
}

TEST(RotationPointing, PointsOneAxisAndTheOtherAsNearlyAsItCan) {
  const Vec3d to{0.6, 0, 0.8};
  const Mat3d turn =
      to_matrix(rotation_pointing({0, 0, 1}, to * 2.0, {0, -1, 0}, {1, 2, 0}).value());
  EXPECT_LT(norm(turn.cz - to), 1e-12);
  // square to the first, on the side of {1, 2, 0}
  EXPECT_LT(norm(-turn.cy - normalized(Vec3d{1, 2, 0} - to * dot(Vec3d{1, 2, 0}, to))), 1e-12);
  for (const Vec3d& along : {to, -to}) {
    EXPECT_FALSE(rotation_pointing({0, 0, 1}, to, {0, -1, 0}, along));
  }
}

}  // namespace
}  // namespace shigusa
