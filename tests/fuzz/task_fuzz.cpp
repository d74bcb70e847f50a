// SPDX-License-Identifier: MIT
// From the bytes of a task file to the problem that it poses: nothing may crash, hang or fill the
// memory, no file is opened, and what was read can be written and read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/project/task_file.hpp>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  auto file = parse_task(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.json");
  if (!file) return 0;
  const std::string text = format_task(*file);
  const auto again = parse_task(text, "written.json");
  if (!again || format_task(*again) != text) std::abort();
  const CharacterSpec& character = file->character;
  const bool built_in = character.source == "half_body" || character.source == "full_body";
  if (!built_in && !character.landmarks) return 0;
  const auto task = make_task(*file, {});
  if (!task) return 0;
  const auto problem = make_problem(*task);
  if (problem && !(problem->duration > 0.0)) std::abort();
  return 0;
}
