// SPDX-License-Identifier: MIT
#include "core/check.hpp"

namespace shigusa {

void fail_check(const std::string& message, const char* condition) {
  throw PreconditionError(message + " [" + condition + "]");
}

void fail_check(const char* message, const char* condition) {
  fail_check(std::string(message), condition);
}

}  // namespace shigusa
