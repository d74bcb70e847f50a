// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>

namespace shigusa {

// Whether a foot is a thigh on a seat: a seated person is supported by both.
[[nodiscard]] bool is_on_seat(const Foot& foot);

[[nodiscard]] bool sits(const BodyModel& body);

}  // namespace shigusa
