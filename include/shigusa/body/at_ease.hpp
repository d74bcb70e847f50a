// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/landmarks.hpp>

namespace shigusa {

// Knees that are straighter are bent to this: exactly straight ones stand at their limit, where no
// small motion lowers the hips.
inline constexpr double kKneesAtEase = radians(5.0);

// The person as one who stands at ease, in their own lengths: the arms hang, elbows bent as
// standing_landmarks has them, each hand straight on as it was; the hips come down until no knee is
// straighter than kKneesAtEase, trunk upright as it was and feet where they are. Characters are
// modelled in a T with straight legs, and nobody reaches from that.
[[nodiscard]] Landmarks at_ease(const Landmarks& person, double stature);

}  // namespace shigusa
