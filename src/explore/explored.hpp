// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>

namespace shigusa {

// Fails on a task with actions, and on one without goals.
[[nodiscard]] Result<void> check_explored(const Task& task);

}  // namespace shigusa
