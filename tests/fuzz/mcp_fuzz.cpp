// SPDX-License-Identifier: MIT
// A session of an assistant, line by line: no crash, hang or memory exhaustion, no file is opened,
// and each answer is a line of JSON with a result or an error.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "assistant/assistant.hpp"

namespace {

// Searches that the readers allow, but whose steps take seconds each, are left to other tests.
bool is_quick(std::string_view line) {
  for (const char* slow : {"generator", "preset", "actions"}) {
    if (line.find(slow) != line.npos) return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  constexpr double kLongest = 0.05;  // s
  Assistant assistant({.seconds = kLongest, .threads = 1}, {});
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (!is_quick(line)) continue;
    (void)assistant.cancel_by(line);
    const auto answer = assistant.answer(line);
    if (!answer) continue;
    const auto json = parse_json(*answer, "answer");
    if (!json || answer->find('\n') != answer->npos) std::abort();
    const auto is_answer = [](const Json& each) {
      return each.contains("id") && each.contains("result") != each.contains("error");
    };
    if (!json->is_array() && !is_answer(*json)) std::abort();
  }
  return 0;
}
