// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/core/progress.hpp>

namespace shigusa {
namespace {

TEST(Progress, WithoutAFlagIsNeverCancelled) { EXPECT_FALSE(Progress{}.cancelled()); }

TEST(Progress, FollowsItsFlag) {
  std::atomic<bool> cancel = false;
  const Progress progress{.report = {}, .cancel = &cancel};
  EXPECT_FALSE(progress.cancelled());
  cancel = true;
  EXPECT_TRUE(progress.cancelled());
}

TEST(Progress, FlagMayBeSetFromASignalHandler) {
  // signal handlers may touch lock-free atomics only
  EXPECT_TRUE(std::atomic<bool>::is_always_lock_free);
}

}  // namespace
}  // namespace shigusa
