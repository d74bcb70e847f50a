// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>

namespace shigusa {

// The conflicting goals and turns of a task out of reach: each of those without which the others
// are in reach. Empty if there is none.
[[nodiscard]] Message conflict_of(const Task& task);

}  // namespace shigusa
