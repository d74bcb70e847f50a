// SPDX-License-Identifier: MIT
// From the bytes of a data set's plan to a few tasks: no crash, hang or memory exhaustion, and a
// drawn task is valid in a file. A shard's head is read from the same bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/dataset.hpp>
#include <string_view>

#include "dataset/shard_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto head = parse_head(bytes); head && head->plan.size() != 64) std::abort();
  // no character is there
  const auto plan = DatasetPlan::parse(bytes, "fuzz.json", "/nowhere");
  if (!plan) return 0;
  const TaskRange last = plan->tasks_of(plan->shards() - 1);
  if (last.last != plan->tasks() || last.first >= last.last) std::abort();
  for (const std::uint64_t number : {std::uint64_t{0}, plan->tasks() - 1}) {
    const auto task = plan->task(number);
    if (task && !parse_task(format_task(task->file), "drawn.json")) std::abort();
  }
  return 0;
}
