// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>

namespace shigusa {

// Fails where the things or the actions of a task are wrong in themselves or in their order, with
// the place "actions[2]": an unknown thing, one that is grasped twice or not held, a hand that is
// full, things in one another or in an obstacle, steps.
[[nodiscard]] Result<void> check_work(const Task& task);

// The action before, if its goals are passed without a stop; null else.
[[nodiscard]] const Action* via_before(const Task& task, std::size_t action);

// Index of a thing by its name, or the number of things.
[[nodiscard]] std::size_t thing_named(const Task& task, std::string_view name);

}  // namespace shigusa
