// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/check.hpp"

namespace shigusa::testing_support {

// The message with which a call with a broken precondition is refused, or "accepted".
template <class Call>
std::string refusal(const Call& call) {
  try {
    (void)call();
  } catch (const PreconditionError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace shigusa::testing_support
