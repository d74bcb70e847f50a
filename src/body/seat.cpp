// SPDX-License-Identifier: MIT
#include "body/seat.hpp"

#include <algorithm>

namespace shigusa {

bool is_on_seat(const Foot& foot) { return foot.name.ends_with("upper_leg"); }

bool sits(const BodyModel& body) {
  return std::any_of(body.feet().begin(), body.feet().end(), is_on_seat);
}

}  // namespace shigusa
