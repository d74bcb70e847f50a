// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>

namespace shigusa {

// The goals and turns of a task out of reach that are in one another's way: those without which all
// others are in reach. Empty where there is none.
[[nodiscard]] Message conflict_of(const Task& task);

}  // namespace shigusa
