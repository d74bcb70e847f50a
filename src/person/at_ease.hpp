// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/landmarks.hpp>

namespace shigusa {

// Knees that are straighter are bent to this: exactly straight ones stand at their limit, where no
// small motion lowers the hips.
inline constexpr double kKneesAtEase = radians(5.0);

// The person as one who stands at ease, in their own lengths: the arms hang, elbows bent as
// standing_landmarks has them, each hand straight on as it was; the hips come down until no knee is
// straighter than kKneesAtEase, trunk upright as it was and feet where they are. Characters are
// modelled in a T with straight legs, and nobody reaches from that.
[[nodiscard]] Landmarks at_ease(const Landmarks& person, double stature);

// Whether a person holds both arms straight and alike out to the sides, 30° to 110° from hanging,
// on straight legs: a T or an A, in which people are modelled and recordings begin.
[[nodiscard]] bool spreads_arms(const Landmarks& person);

// Whether a person stands as one who has not begun to move: upright on both feet, knees no more
// than a little bent, left and right alike. A person who leaps or is ready to fight does not.
[[nodiscard]] bool stands_at_rest(const Landmarks& person, double stature);

// Height of the hip joints over the seat, as a share of the stature: some 9 cm, an estimate. The
// forearms of a seated person point down by kSeatedForearms, to lay the hands on the thighs.
inline constexpr double kSeatedHip = 0.05;
inline constexpr double kSeatedForearms = radians(20.0);

// The person sitting upright on a seat of that height (m, of its surface), in their own lengths:
// thighs ahead, shanks upright on flat feet that are where they were, hands on the thighs. From a
// seat too high for that the feet hang.
[[nodiscard]] Landmarks seated(const Landmarks& person, double stature, double seat);

}  // namespace shigusa
