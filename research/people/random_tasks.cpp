// SPDX-License-Identifier: MIT
#include "random_tasks.hpp"

#include "support/random_tasks.hpp"

namespace shigusa::bench {
namespace {

using testing_support::kTaskKinds;
using testing_support::TaskKind;

// Number of the first kinds of random tasks, which have hand goals only.
constexpr int kHandKinds = 5;
static_assert(kTaskKinds[kHandKinds] == TaskKind::obstacle);
constexpr std::array<const char*, kHandKinds> kNames{
    "a place", "both hands", "a rotation", "the way a palm faces", "a load of 1 to 40 kg"};

}  // namespace

std::span<const char* const> hand_task_kinds() { return kNames; }

Task hand_task(int index) {
  const int all = static_cast<int>(kTaskKinds.size());
  const int random = index / kHandKinds * all + index % kHandKinds;
  TaskFile file = testing_support::random_task(static_cast<std::uint64_t>(random));
  file.character.source = "human";
  adopt_preset(file, Preset::flat);
  Task task = make_task(file, {}).value();
  task.batch.threads = 1;
  return task;
}

}  // namespace shigusa::bench
