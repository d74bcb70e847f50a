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
    MessageText{"lift_one_hand", "the lifting equation is for two hands, and one holds {}"},
    MessageText{"lift_sits", "the lifting equation is for standing people"},
    MessageText{"lift_fast",
                "the lifting equation is for slower lifts: the hands move at {:.2f} m/s"},
    MessageText{"cost_no_neck", "the body's head does not move against its trunk: it is neutral"},
    MessageText{"cost_no_wrists", "the body has no wrists: they are neutral"},
    MessageText{"cost_home_leans",
                "the body's own start is no neutral posture: all angles at 0 are taken instead"},
    MessageText{"cost_rigid_trunk",
                "the trunk is rigid: the moment at L5/S1 is a share of that about the hips, and "
                "forces are not known"},
    MessageText{"cost_lacks_parts", "the body lacks parts that REBA and RULA score"},
    MessageText{"cost_option", "is {:g}; allowed is {}"},
};

}  // namespace shigusa::messages
