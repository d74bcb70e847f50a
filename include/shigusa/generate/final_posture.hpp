// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace shigusa {

// The posture that a motion ends in, as a person would describe it, measured on the places of
// joints.
struct FinalPosture {
  double knee_flexion = 0.0;  // rad, mean of the knees that stand
  // 100 (1 - drop of the hips / drop of the shoulders), people's bending: below 30 a full squat,
  // above 90 a full stoop (after S. Schmid et al., European Spine Journal 31 (2022)); none where
  // the shoulders come down by less than a tenth of the stature
  std::optional<double> stoop_squat_index;
  double trunk_turn = 0.0;  // rad, of the line of the shoulders about the vertical, left is > 0
  // rad, of the elbow about the line from shoulder to hand: 0 hangs down, > 0 points outwards; of
  // the first goal's arm, 0 for a hand that is no arm's or an arm that is straight
  double elbow_swivel = 0.0;
};

// A stoop-squat index below this is called a squat; half way between squat and stoop is neither.
inline constexpr double kSquatIndex = 40.0;
// A stoop-squat index above this is called a stoop.
inline constexpr double kStoopIndex = 80.0;

// "stoop", "squat, turned left", "upright, elbow out": what tells it from others in a few words.
[[nodiscard]] std::string posture_words(const FinalPosture& posture);

}  // namespace shigusa
