// SPDX-License-Identifier: MIT
// Random tasks of all kinds keep what is promised; scripts/make_reliability has twenty thousand.
#include <gmock/gmock.h>

#include "support/night.hpp"
#include "support/task_audit.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Builds that check every step take fifteen times as long for a task.
#ifdef NDEBUG
constexpr int kByDay = 200;
#else
constexpr int kByDay = 14;
#endif

TEST(RandomTasks, KeepWhatIsPromised) {
  Auditor auditor;
  const int tasks = cases(10 * kByDay, kByDay);
  for (int index = 0; index < tasks; ++index) {
    auditor.take(random_task(static_cast<std::uint64_t>(index)), 300);
  }
  const Audit& audit = auditor.audit();
  EXPECT_THAT(audit.failures, testing::IsEmpty());
  // otherwise the tasks show nothing of one side
  EXPECT_GT(audit.statuses.at("reached"), tasks / 4);
  EXPECT_GT(audit.statuses.at("unsteady"), 0);
  EXPECT_LE(audit.through, audit.candidates / 100);
}

}  // namespace
}  // namespace shigusa
