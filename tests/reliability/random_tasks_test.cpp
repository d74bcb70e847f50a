// SPDX-License-Identifier: MIT
// Random tasks of all kinds keep the promises; scripts/make_reliability runs twenty thousand.
#include <gmock/gmock.h>

#include <algorithm>
#include <string_view>

#include "reliability/auditor.hpp"
#include "support/night.hpp"

namespace shigusa::bench {
namespace {

// Builds that check every step take fifteen times as long per task.
#ifdef NDEBUG
constexpr int kByDay = 10;
#else
constexpr int kByDay = 1;
#endif

TEST(RandomTasks, KeepWhatIsPromised) {
  // of our own files alone: those of others differ from place to place
  const Cast cast = load_cast({});
  const int each = testing_support::cases(10 * kByDay, kByDay);
  Audit all;
  for (const Kind& kind : all_kinds()) {
    Auditor auditor(150);
    for (int number = 0; number < each; ++number) {
      auditor.take(kind, kind.draw(cast, static_cast<std::uint64_t>(number)));
    }
    EXPECT_THAT(auditor.audit().failures, testing::IsEmpty()) << kind.name;
    all.add(auditor.audit());
  }
  // otherwise the tasks show nothing of one side
  EXPECT_GT(all.statuses.at("reached"), all.tasks / 4);
  EXPECT_GT(all.statuses.at("unsteady"), 0);
  EXPECT_LE(all.through, all.fleshed / 100);
  EXPECT_LE(all.refused, all.tasks / 20);
}

TEST(RandomTasks, TellAFreeHandThatGoesThroughWhatItMightRestOn) {
  const auto kinds = all_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [](const Kind& each) {
    return std::string_view(each.name) == "a hand on a box";
  });
  Auditor auditor(150);
  // its first candidate's free hand is 5 cm in the stool
  auditor.take(*kind, kind->draw(load_cast({}), 23));
  EXPECT_THAT(auditor.audit().failures, testing::IsEmpty());
}

}  // namespace
}  // namespace shigusa::bench
