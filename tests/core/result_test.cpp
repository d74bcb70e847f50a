// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/error.hpp>

namespace shigusa {
namespace {

Result<int> half(int n) {
  if (n % 2 != 0) return fail(ErrorCode::invalid_argument, "3 is odd; allowed: even", "line 1");
  return n / 2;
}

TEST(Result, HoldsAValue) { EXPECT_EQ(half(4).value(), 2); }

TEST(Result, HoldsWhatFailWasGiven) {
  const Result<int> result = half(3);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::invalid_argument);
  EXPECT_EQ(result.error().message, "3 is odd; allowed: even");
  EXPECT_EQ(result.error().place, "line 1");
}

TEST(Error, ToStringPutsThePlaceFirst) {
  EXPECT_EQ((Error{ErrorCode::parse, "no joints", "line 12 of walk.bvh"}).to_string(),
            "line 12 of walk.bvh: no joints");
}

TEST(Error, ToStringWithoutAPlaceIsTheMessage) {
  EXPECT_EQ((Error{ErrorCode::parse, "no joints", {}}).to_string(), "no joints");
}

}  // namespace
}  // namespace shigusa
