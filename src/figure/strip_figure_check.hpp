// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/strip_figure.hpp>

namespace shigusa::strip {

// Nothing further away than this is drawn, in the skeleton's unit: it would overflow later on.
inline constexpr double kFarthest = 1e12;

// Settings, motion and overlay are within what draw_strip allows. Positions of nodes are looked at
// when they are computed, for the drawn frames alone.
[[nodiscard]] Result<void> check_strip(const SkeletonMotion& motion, const StripOverlay& overlay,
                                       const StripSettings& settings);

}  // namespace shigusa::strip
