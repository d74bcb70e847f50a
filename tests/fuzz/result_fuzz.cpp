// SPDX-License-Identifier: MIT
// From the bytes of a result to editable parameters: no crash, hang or memory exhaustion, and no
// file is opened.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/files.hpp>
#include <string>
#include <string_view>

#include "plan/assignment.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  auto result =
      parse_result(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.json");
  if (!result) return 0;
  const auto task = make_task(result->task, {});
  if (!task) return 0;
  const auto list = parameter_list(task->body, task->start, *task);
  if (!list) std::abort();
  for (Parameters& parameters : result->candidates) {
    if (!list->check(parameters)) std::abort();
    const std::string first = list->all.front().name;
    if (!assign_parameter(*list, first + ".weight=2", parameters)) std::abort();
    if (assign_parameter(*list, "later." + first + ".weight=2", parameters)) std::abort();
  }
  return 0;
}
