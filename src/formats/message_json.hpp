// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <span>

#include "formats/json_text.hpp"

namespace shigusa {

// {"text", "key", "values"} of a sentence, {"text", "number", "unit" (of lengths)} of a number, and
// of anything else its text.
[[nodiscard]] Json message_to_json(const Message& message);
[[nodiscard]] Json messages_to_json(std::span<const Message> messages);

// Their English texts.
[[nodiscard]] Json texts_to_json(std::span<const Message> messages);

}  // namespace shigusa
