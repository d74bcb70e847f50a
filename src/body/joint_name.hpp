// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// "left_" or "right_".
[[nodiscard]] std::string side_prefix(Side side);

// "hip.flexion" of "left_hip.flexion"; a name without a side as it is.
[[nodiscard]] std::string_view without_side(std::string_view name);

// "right_hip.flexion" of "left_hip.flexion"; a name without a side as it is.
[[nodiscard]] std::string with_other_side(std::string_view name);

}  // namespace shigusa
