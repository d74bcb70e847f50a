// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <shigusa/run.hpp>

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

TEST(Progress, IsCancelledOnceItsDeadlineHasPassed) {
  const auto now = std::chrono::steady_clock::now();
  EXPECT_TRUE(Progress{.deadline = now}.cancelled());
  EXPECT_FALSE(Progress{.deadline = now + std::chrono::hours(1)}.cancelled());
}

TEST(Progress, FlagCountsBeforeTheDeadline) {
  const std::atomic<bool> cancel = true;
  const auto later = std::chrono::steady_clock::now() + std::chrono::hours(1);
  EXPECT_TRUE((Progress{.cancel = &cancel, .deadline = later}.cancelled()));
}

TEST(Progress, FlagMayBeSetFromASignalHandler) {
  // signal handlers may touch lock-free atomics only
  EXPECT_TRUE(std::atomic<bool>::is_always_lock_free);
}

}  // namespace
}  // namespace shigusa
