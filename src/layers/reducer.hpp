// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "layers/layer.hpp"

namespace shigusa {

// The body on which the upper layer moves: the trunk with its joints, as the body starts, and rods
// of variable length for its limbs.
[[nodiscard]] ReducedBody reduced_body(const BodyModel& body, const BodyLimbs& limbs);

}  // namespace shigusa
