// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/explore.hpp>

#include "draw/strip_figure_canvas.hpp"

namespace shigusa {

using strip::Colour;

// Score of a possible place whose colour is in the middle between green and yellow.
inline constexpr double kMiddleScore = 0.5;

// The colour of a place: green to yellow by the score if it is possible, orange, red or, out of
// reach, grey.
[[nodiscard]] Colour colour_of(const MapPlace& place);

}  // namespace shigusa
