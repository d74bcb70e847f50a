// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/action.hpp>
#include <shigusa/body.hpp>

#include "work/moment.hpp"

namespace shigusa {

// Flexion of the fingers of a hand on a thing, relative to that of a relaxed hand: they bend until
// one of their bones touches it, at most to a fist. So they lie flat on a side that is longer than
// they are, and close more the narrower the thing is. 1 for a hand without fingertips.
[[nodiscard]] double flexion_about(const BodyModel& body, const Grip& grip, const Thing& thing);

}  // namespace shigusa
