// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <span>

#include "formats/json_text.hpp"

namespace shigusa {

// JSON of a message: {"text", "key", "values"} for a sentence, {"text", "number", "unit" (of
// lengths)} for a number, the text for anything else.
[[nodiscard]] Json message_to_json(const Message& message);
[[nodiscard]] Json messages_to_json(std::span<const Message> messages);

// English texts of messages.
[[nodiscard]] Json texts_to_json(std::span<const Message> messages);

}  // namespace shigusa
