// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace shigusa {

// The name of `known` that is nearest to `name` by edit distance; empty when none shares a third of
// it. For messages about misspelt names.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string> known);

// "unknown effector 'right_hnad'; did you mean 'right_hand'? Known: left_hand, right_hand".
[[nodiscard]] std::string unknown_name(std::string_view kind, std::string_view name,
                                       std::span<const std::string> known);

}  // namespace shigusa
