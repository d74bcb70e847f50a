// SPDX-License-Identifier: MIT
#include "core/check.hpp"

#include <gtest/gtest.h>

#include <string>

namespace shigusa {
namespace {

std::string message_of(int count) {
  try {
    SHG_CHECK(count > 0, "count is " + std::to_string(count));
  } catch (const PreconditionError& error) {
    return error.what();
  }
  return {};
}

TEST(Check, HeldConditionThrowsNothing) { EXPECT_EQ(message_of(1), ""); }

TEST(Check, BrokenConditionNamesTheMessageAndTheCondition) {
  EXPECT_EQ(message_of(-2), "count is -2 [count > 0]");
}

TEST(Check, IsOneStatementAfterAnIf) {
  // would not compile, or would take the else for its own, were it not
  const auto run = [](bool now) {
    if (now)
      SHG_CHECK(false, "now");
    else
      return true;
    return false;
  };
  EXPECT_TRUE(run(false));
  EXPECT_THROW(run(true), PreconditionError);
}

TEST(Check, EvaluatesTheConditionOnce) {
  int count = 0;
  SHG_CHECK(++count == 1, "count");
  EXPECT_EQ(count, 1);
}

TEST(Assert, ThrowsInDebugBuildsOnly) {
  const auto run = [] { SHG_ASSERT(1 + 1 == 3); };
#ifdef NDEBUG
  EXPECT_NO_THROW(run());
#else
  EXPECT_THROW(run(), PreconditionError);
#endif
}

}  // namespace
}  // namespace shigusa
