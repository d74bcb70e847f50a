// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <span>
#include <vector>

// Random tasks of hands for the built-in body `human`: places, both hands, rotations, axes, loads.
namespace shigusa::bench {

// The kinds in the order in which tasks have them, one after the other.
[[nodiscard]] std::span<const char* const> hand_task_kinds();

// The task of that index, always the same; its kind is index % hand_task_kinds().size(). Statures
// of 1.45 to 2.00 m, both sexes, goals within and beyond reach, the preset flat on one thread.
[[nodiscard]] Task hand_task(int index);

}  // namespace shigusa::bench
