// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/messages/message_text.hpp"

namespace shigusa::messages {

// Sentences of what a motion costs the body.
inline constexpr std::array kCost{
    MessageText{"lift_number", "is {:g}; allowed is 0 or more"},
    MessageText{"lift_too_far", "no load is allowed: the hands are too far from the ankles"},
    MessageText{"lift_too_high", "no load is allowed: the hands are too high"},
    MessageText{"lift_too_long", "no load is allowed: the way up or down is too long"},
    MessageText{"lift_too_turned", "no load is allowed: the hands are turned by more than 135°"},
    MessageText{"lift_too_often",
                "no load is allowed: {:g} lifts a minute are too many for this duration"},
    MessageText{"lift_between",
                "for {:g} lifts a minute the table has no value: it lies between a row and one in "
                "which no load is allowed"},
    MessageText{"lift_none_allowed",
                "there is no index of all lifts: one of them is not allowed with any load"},
};

}  // namespace shigusa::messages
