// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <shigusa/run.hpp>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/check.hpp"

namespace shigusa {
namespace {

constexpr int kThreads[] = {0, 1, 2, 3, 8};

TEST(ThreadCount, IsWhatIsAskedForOrOne) {
  for (const int threads : {1, 2, 3, 8, kMaxThreads}) {
    const int count = thread_count(threads);
    // one where the library was built without threads
    EXPECT_TRUE(count == threads || count == 1) << threads;
  }
  EXPECT_GE(thread_count(0), 1);
}

TEST(ThreadCount, OutOfRangeIsRefused) {
  EXPECT_THROW((void)thread_count(-1), PreconditionError);
  EXPECT_THROW((void)thread_count(kMaxThreads + 1), PreconditionError);
  EXPECT_THROW(parallel_for(3, -1, [](int, int) {}), PreconditionError);
}

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const int threads : kThreads) {
    for (const int count : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
      parallel_for(count, threads,
                   [&](int index, int) { ++calls[static_cast<std::size_t>(index)]; });
      for (const std::atomic<int>& times : calls) EXPECT_EQ(times, 1);
    }
  }
}

TEST(ParallelFor, WorkersAreWithinTheThreadCount) {
  for (const int threads : kThreads) {
    std::atomic<bool> within{true};
    parallel_for(500, threads, [&](int, int worker) {
      if (worker < 0 || worker >= thread_count(threads)) within = false;
    });
    EXPECT_TRUE(within) << threads;
  }
}

TEST(ParallelFor, AWorkerIsNeverInTwoCallsAtOnce) {
  for (const int threads : kThreads) {
    std::vector<std::atomic<int>> inside(static_cast<std::size_t>(thread_count(threads)));
    std::atomic<bool> shared{false};
    parallel_for(2000, threads, [&](int, int worker) {
      std::atomic<int>& calls = inside[static_cast<std::size_t>(worker)];
      if (++calls != 1) shared = true;
      for (int k = 0; k < 100; ++k) calls.load();
      --calls;
    });
    EXPECT_FALSE(shared) << threads;
  }
}

TEST(ParallelFor, AWorkersScratchMemoryNeedsNoLock) {
  // plain numbers, so that the thread sanitizer sees two calls that share a worker
  for (const int threads : kThreads) {
    std::vector<long> sums(static_cast<std::size_t>(thread_count(threads)));
    parallel_for(1000, threads,
                 [&](int index, int worker) { sums[static_cast<std::size_t>(worker)] += index; });
    long total = 0;
    for (const long sum : sums) total += sum;
    EXPECT_EQ(total, 999L * 1000 / 2);
  }
}

TEST(ParallelFor, WhatACallThrowsIsPassedOn) {
  for (const int threads : kThreads) {
    const auto work = [](int index, int) {
      if (index == 37) throw std::runtime_error("thirty-seven");
    };
    EXPECT_THROW(parallel_for(100, threads, work), std::runtime_error) << threads;
  }
}

TEST(ParallelFor, ServesSeveralThreadsAtOnce) {
  std::vector<long> totals(3);
  std::vector<std::thread> callers;
  for (long& total : totals) {
    callers.emplace_back([&total] {
      for (int round = 0; round < 50; ++round) {
        std::vector<long> sums(3);
        parallel_for(
            20, 3, [&](int index, int worker) { sums[static_cast<std::size_t>(worker)] += index; });
        for (const long sum : sums) total += sum;
      }
    });
  }
  for (std::thread& caller : callers) caller.join();
  for (const long total : totals) EXPECT_EQ(total, 50L * 190);
}

TEST(ParallelFor, WorksWithinItself) {
  std::atomic<int> calls{0};
  parallel_for(4, 2, [&](int, int) { parallel_for(5, 2, [&](int, int) { ++calls; }); });
  EXPECT_EQ(calls, 20);
}

}  // namespace
}  // namespace shigusa
