// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body/body_model.hpp>
#include <shigusa/kinematics/forward_kinematics.hpp>
#include <span>
#include <string>

namespace shigusa {

// What a person would say about the posture that a motion ends in, measured on its joints' places.
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

// Where words begin: half way between squat and stoop is neither.
inline constexpr double kSquatIndex = 40.0;
inline constexpr double kStoopIndex = 80.0;

// Measures postures of one body, which outlives it, beside its start.
class PostureMeter {
 public:
  explicit PostureMeter(const BodyModel& body);

  // Of angles (dofs, rad); `effector` is the index of the hand that the elbow belongs to.
  [[nodiscard]] FinalPosture measure(std::span<const double> angles, int effector);
  // The stoop-squat index alone.
  [[nodiscard]] std::optional<double> index(std::span<const double> angles);

 private:
  enum Place { kLeftHip, kRightHip, kLeftShoulder, kRightShoulder, kLeftElbow, kRightElbow };
  static constexpr std::size_t kPlaces = 8;  // and the wrists, in the same order

  [[nodiscard]] bool known(std::size_t place) const { return nodes_[place] != nullptr; }
  [[nodiscard]] Vec3d at(std::size_t place) const;
  [[nodiscard]] Vec3d between(std::size_t left) const;  // that place and the next, or one of them
  [[nodiscard]] std::optional<double> index_now() const;
  [[nodiscard]] double heading() const;
  [[nodiscard]] double elbow_swivel(int effector) const;

  const BodyModel& body_;
  std::array<const BodyNode*, kPlaces> nodes_{};
  Kinematics<double> kinematics_;
  double hip_height_ = 0.0;       // m, at the start …
  double shoulder_height_ = 0.0;  // m …
  double heading_ = 0.0;          // rad
};

// "stoop", "squat, turned left", "upright, elbow out": what tells it from others in a few words.
[[nodiscard]] std::string posture_words(const FinalPosture& posture);

}  // namespace shigusa
