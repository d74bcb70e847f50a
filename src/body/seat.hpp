// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <shigusa/body.hpp>

namespace shigusa {

// Whether a foot is a thigh on a seat: a seated person is supported by both.
[[nodiscard]] inline bool is_on_seat(const Foot& foot) { return foot.name.ends_with("upper_leg"); }

[[nodiscard]] inline bool sits(const BodyModel& body) {
  return std::any_of(body.feet().begin(), body.feet().end(), is_on_seat);
}

}  // namespace shigusa
