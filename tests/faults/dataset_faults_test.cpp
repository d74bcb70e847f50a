// SPDX-License-Identifier: MIT
// However a program ends while it makes a data set, each shard is complete or absent; and the same
// command continues.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "dataset/plans.hpp"
#include "faults/system_calls.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

class DatasetFaults : public testing::Test {
 protected:
  // Makes the set in a process of its own, in which that call meets the fault; false where the run
  // made fewer calls. The outcome stands in `code`: 0 made, 1 refused, -1 killed.
  bool make_with(Fault fault, int call, int& code) const {
    const pid_t child = fork();
    if (child == 0) {
      arm(fault, call);
      // a child has none of its parent's threads, and would wait for them
      const bool done = make_dataset(plan_, {.folder = work_.path(), .threads = 1}).has_value();
      const bool reached = calls_made() >= call;
      arm(Fault::none, 0);
      _exit((done ? 0 : 1) + (reached ? 0 : 2));
    }
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    code = WIFEXITED(status) ? WEXITSTATUS(status) & 1 : -1;
    return !WIFEXITED(status) || (WEXITSTATUS(status) & 2) == 0;
  }

  void expect_whole_after(Fault fault) {
    const WorkFolder wanted;
    made(plan_, {.folder = wanted.path(), .threads = 1});
    int call = 1;
    for (int code = 0;; ++call) {
      for (std::uint64_t shard = 0; shard < plan_.shards(); ++shard) {
        std::filesystem::remove(work_ / shard_name(shard));
      }
      const bool met = make_with(fault, call, code);
      for (std::uint64_t shard = 0; shard < plan_.shards(); ++shard) {
        const std::filesystem::path path = work_ / shard_name(shard);
        EXPECT_TRUE(!std::filesystem::exists(path) || ShardReader::open(path)) << call;
      }
      EXPECT_TRUE(fault != Fault::disk_full || !met || code == 1) << "told, at call " << call;
      // the remains of the fault are gone too
      made(plan_, {.folder = work_.path(), .threads = 1});
      EXPECT_TRUE(work_.contents() == wanted.contents()) << call;
      if (!met) break;
    }
    // three calls a shard at least: it is made, written and settled
    EXPECT_GT(call, 3 * 2);
  }

  WorkFolder work_;
  const DatasetPlan plan_ = plan_of_json(small_plan(2, 1));
};

TEST_F(DatasetFaults, KilledBeforeAnyCall) { expect_whole_after(Fault::killed_before); }
TEST_F(DatasetFaults, KilledAfterAnyCall) { expect_whole_after(Fault::killed_after); }
TEST_F(DatasetFaults, AFullDiskAtAnyCall) { expect_whole_after(Fault::disk_full); }

}  // namespace
}  // namespace shigusa
