// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>

namespace shigusa {

// Knees that are straighter are bent to this: exactly straight ones stand at their limit, where no
// small motion lowers the hips.
inline constexpr double kKneesAtEase = radians(5.0);

// The person as one who stands at ease, in their own lengths. The arms hang, elbows bent as
// standing_landmarks has them, each hand straight on as it was, raised outwards until they clear
// trunk and legs. The body leans at the ankles until its mass is over the middle of the soles, as
// people's is; the hips come down until no knee is straighter than kKneesAtEase, the trunk turned
// as it was and the feet where they are. Characters are modelled in a T with straight legs, and
// nobody reaches from that.
[[nodiscard]] Landmarks at_ease(const Landmarks& person, double stature);

// Height of the hip joints over the seat, as a share of the stature: some 9 cm, an estimate. The
// forearms of a seated person point down by kSeatedForearms, to lay the hands on the thighs.
inline constexpr double kSeatedHip = 0.05;
inline constexpr double kSeatedForearms = radians(20.0);

// The person sitting upright on a seat of that height (m, of its surface), in their own lengths:
// thighs ahead, shanks upright on flat feet that are where they were, hands on the thighs. From a
// seat too high for that the feet hang.
[[nodiscard]] Landmarks seated(const Landmarks& person, double stature, double seat);

}  // namespace shigusa
