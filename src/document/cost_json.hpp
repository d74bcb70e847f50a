// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/cost.hpp>

#include "formats/json_reader.hpp"

namespace shigusa {

// The cost of a motion as results tell it, with the options that it is computed by.
[[nodiscard]] Json cost_to_json(const MotionCost& cost, const Ergonomics& ergonomics);

}  // namespace shigusa
