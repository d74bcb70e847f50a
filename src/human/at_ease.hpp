// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>

namespace shigusa {

// Least bend of the knees at ease: straight knees are at their limit, where no small motion lowers
// the hips.
inline constexpr double kKneesAtEase = radians(5.0);

// The person standing at ease, with their own segment lengths. The arms hang with the elbows bent
// as in standing_landmarks and the hands as they were on the forearms, raised outwards until they
// clear trunk and legs. The body leans at the ankles until its mass is over the middle of the
// soles, as people's is; the hips come down until each knee is bent by at least kKneesAtEase, while
// trunk orientation and feet are kept. Characters are modelled in a T pose with straight legs,
// which is no natural start.
[[nodiscard]] Landmarks at_ease(const Landmarks& person, double stature);

// Height of the hip joints over the seat, as a share of the stature: some 9 cm, an estimate. The
// forearms of a seated person point down by kSeatedForearms, to lay the hands on the thighs.
inline constexpr double kSeatedHip = 0.05;
inline constexpr double kSeatedForearms = radians(20.0);

// The person sitting upright on a seat at that height (m), with their own segment lengths: thighs
// ahead, shanks vertical, feet flat and in place, hands on the thighs. On a seat too high for that
// the feet hang.
[[nodiscard]] Landmarks seated(const Landmarks& person, double stature, double seat);

}  // namespace shigusa
