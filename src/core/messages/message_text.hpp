// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace shigusa {

// A sentence for a person in English, with a hole as fmt has it for each value, and the key by
// which a page has it in other languages.
struct MessageText {
  std::string_view key;
  std::string_view text;
};

}  // namespace shigusa
