// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/goal.hpp>
#include <span>

namespace shigusa {

// The place above the obstacles that a straight way passes through; none if it passes by.
[[nodiscard]] std::optional<Vec3d> place_over(std::span<const Obstacle> obstacles,
                                              const Vec3d& from, const Vec3d& to);

}  // namespace shigusa
