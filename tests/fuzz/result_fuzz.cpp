// SPDX-License-Identifier: MIT
// From the bytes of a result to parameters that can be edited: nothing may crash, hang or fill the
// memory, and no file is opened.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/document/result_file.hpp>
#include <shigusa/generate/layered_problem.hpp>
#include <shigusa/layers/layered_parameters.hpp>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  auto result =
      parse_result(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.json");
  if (!result) return 0;
  const auto task = make_task(result->task, {});
  if (!task) return 0;
  for (Parameters& parameters : result->candidates) {
    if (parameters.joints.size() != task->body.dofs().size()) std::abort();
    if (!assign_parameter(task->body, "right_elbow.weight=2", parameters)) std::abort();
    if (!assign_parameter(task->body, "later.right_elbow.weight=2", parameters)) std::abort();
  }
  if (result->layered.empty()) return 0;
  const auto layers = layers_to_goals(*task);
  if (!layers) std::abort();
  for (LayeredParameters& parameters : result->layered) {
    if (!check_layered(*layers, parameters)) std::abort();
    const std::string first = layers->front().genes.front().name;
    if (!assign_parameter(*layers, first + ".weight=2", parameters)) std::abort();
  }
  return 0;
}
