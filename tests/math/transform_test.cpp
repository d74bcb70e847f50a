// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/math.hpp>

namespace shigusa {
namespace {

const Transformd kX{rotation(Axis::z, 0.4) * rotation(Axis::x, -1.1), {1, -2, 0.5}};
const Transformd kY{rotation(Axis::y, 2.2), {0.3, 0.1, -4}};
const Vec3d kPoint{0.7, -0.2, 1.5};
// coordinates up to 5 through some ten roundings
constexpr double kBound = 1e-14;

TEST(Transform, TurnsThenMoves) {
  const Transformd x{rotation(Axis::z, kPi / 2), {10, 0, 0}};
  EXPECT_LT(norm(x * Vec3d{1, 0, 0} - Vec3d{10, 1, 0}), kBound);
}

TEST(Transform, OfNothingLeavesThePoint) { EXPECT_EQ(Transformd{} * kPoint, kPoint); }

TEST(Transform, ProductAppliesTheRightOneFirst) {
  EXPECT_LT(norm((kX * kY) * kPoint - kX * (kY * kPoint)), kBound);
}

TEST(Transform, InverseUndoesIt) {
  EXPECT_LT(norm(inverse(kX) * (kX * kPoint) - kPoint), kBound);
  EXPECT_LT(norm(kX * (inverse(kX) * kPoint) - kPoint), kBound);
}

}  // namespace
}  // namespace shigusa
