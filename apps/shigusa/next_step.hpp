// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>

namespace shigusa::app {

// Suggestion to append to an error, "; did you mean 'task.json'?"; empty if the error has one.
[[nodiscard]] std::string next_step(const Error& error);

// Hint "; 155 cm are 1.55" if a length in metres is plausible in centimetres; else empty.
[[nodiscard]] std::string centimetre_hint(double metres, double low, double high);

// Result whose error gets a place, "--formats", if it has none.
template <class Value>
[[nodiscard]] Result<Value> placed(const char* place, Result<Value> result) {
  if (!result && result.error().place.empty()) result.error().place = place;
  return result;
}

// Result with a text appended to its error's message.
template <class Value>
[[nodiscard]] Result<Value> with_hint(Result<Value> result, const std::string& hint) {
  if (!result && !hint.empty()) result.error().message = result.error().message.text + hint;
  return result;
}

}  // namespace shigusa::app
