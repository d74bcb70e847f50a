// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/core/result.hpp>
#include <shigusa/math/quat.hpp>
#include <span>
#include <string>
#include <string_view>

namespace shigusa {

// An axis of a hand by its word, in the hand's frame (see GoalAxis): "palm" where it faces, "thumb"
// along what it grips, to the thumb's side, "fingers" where they point. Fails on other words, and
// on effectors that are no hands or wrists.
[[nodiscard]] Result<Vec3d> hand_axis(std::string_view word, std::string_view effector);
// The words that hand_axis knows.
[[nodiscard]] std::span<const std::string> hand_axis_words();

// A direction of the world by its word: "up", "down", "left", "right", "ahead" or "back", as the
// body stands at the start.
[[nodiscard]] Result<Vec3d> direction_named(std::string_view word);
// The words that direction_named knows.
[[nodiscard]] std::span<const std::string> direction_words();

// The rotation that points axis `a` to `to_a`, and axis `b`, square to a, as nearly as that allows
// to `to_b`. Fails where to_b is along to_a.
[[nodiscard]] Result<Quatd> rotation_pointing(const Vec3d& a, const Vec3d& to_a, const Vec3d& b,
                                              const Vec3d& to_b);

}  // namespace shigusa
