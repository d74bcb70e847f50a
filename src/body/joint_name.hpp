// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// Prefix of a side, "left_" or "right_".
[[nodiscard]] std::string side_prefix(Side side);

// Name without its side: "hip.flexion" for "left_hip.flexion"; others are unchanged.
[[nodiscard]] std::string_view without_side(std::string_view name);

// Name on the other side: "right_hip.flexion" for "left_hip.flexion"; others are unchanged.
[[nodiscard]] std::string with_other_side(std::string_view name);

}  // namespace shigusa
