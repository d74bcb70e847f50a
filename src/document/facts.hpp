// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>

namespace shigusa {

/// All that a user interface has to know beside a body, as JSON text: criteria, mixtures, presets
/// with the mixture that each ranks by, the words of enums, ranges of what a person sets, and file
/// formats. bindings/c/include/shigusa.h says its keys (shigusa_facts).
[[nodiscard]] std::string format_facts();

/// An error as JSON text, of which a user interface words the message in its reader's language:
/// {"place", "message"}, as bindings/c/include/shigusa.h says (shigusa_failure).
[[nodiscard]] std::string format_failure(const Error& error);

}  // namespace shigusa
