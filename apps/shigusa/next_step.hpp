// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>

namespace shigusa::app {

// What to try after an error, "; did you mean 'task.json'?"; empty where the error says it.
[[nodiscard]] std::string next_step(const Error& error);

// "; 155 cm are 1.55" where a length in metres makes sense in centimetres; else empty.
[[nodiscard]] std::string centimetre_hint(double metres, double low, double high);

// The result with a place for its error, "--formats", where it has none.
template <class Value>
[[nodiscard]] Result<Value> placed(const char* place, Result<Value> result) {
  if (!result && result.error().place.empty()) result.error().place = place;
  return result;
}

// The result with more words at the end of its error's message.
template <class Value>
[[nodiscard]] Result<Value> with_hint(Result<Value> result, const std::string& hint) {
  if (!result && !hint.empty()) result.error().message = result.error().message.text + hint;
  return result;
}

}  // namespace shigusa::app
