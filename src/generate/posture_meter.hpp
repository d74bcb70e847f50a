// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/generate.hpp>
#include <span>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// Measures postures of one body relative to its home. The body outlives it.
class PostureMeter {
 public:
  PostureMeter(const BodyModel& body, const State& home);

  // Measures angles (dofs, rad); `effector` is the index of the hand whose elbow is measured.
  [[nodiscard]] FinalPosture measure(std::span<const double> angles, int effector);
  // The stoop-squat index alone.
  [[nodiscard]] std::optional<double> index(std::span<const double> angles);

 private:
  enum Place { kLeftHip, kRightHip, kLeftShoulder, kRightShoulder, kLeftElbow, kRightElbow };
  static constexpr std::size_t kPlaces = 8;  // including the wrists, in the same order

  [[nodiscard]] bool known(std::size_t place) const { return nodes_[place] != nullptr; }
  [[nodiscard]] Vec3d at(std::size_t place) const;
  [[nodiscard]] Vec3d between(std::size_t left) const;  // midpoint with the next, or either
  [[nodiscard]] std::optional<double> index_now() const;
  [[nodiscard]] double trunk_lean() const;
  [[nodiscard]] double heading() const;
  [[nodiscard]] double elbow_swivel(int effector) const;

  const BodyModel& body_;
  std::array<const BodyNode*, kPlaces> nodes_{};
  Kinematics<double> kinematics_;
  bool sits_ = false;
  double hip_height_ = 0.0;       // m, at home
  double shoulder_height_ = 0.0;  // m, at home
  double heading_ = 0.0;          // rad, at home
};

// Whether a final posture is unnatural: folded over straight knees, crouching with the shoulders
// up, or with an elbow pointing inwards.
[[nodiscard]] bool is_strange(const FinalPosture& posture);

}  // namespace shigusa
