// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>

namespace shigusa {

/// Facts for user interfaces as JSON: criteria, mixtures, presets with their default mixture, words
/// of enums, ranges of user settings, and file formats. The keys are documented at shigusa_facts in
/// bindings/c/include/shigusa.h.
[[nodiscard]] std::string format_facts();

/// Formats an error as JSON that a user interface can translate: {"place", "message"}, documented
/// at shigusa_failure in bindings/c/include/shigusa.h.
[[nodiscard]] std::string format_failure(const Error& error);

}  // namespace shigusa
