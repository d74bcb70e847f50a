// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/generate.hpp>
#include <span>
#include <vector>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// The final posture as a person sees it. Angles and places that a body lacks are 0.
struct Look {
  std::vector<Vec3d> places{};    // m, of the body's joints
  bool arms = false;              // has elbows
  std::array<Vec3d, 2> elbows{};  // m
  Vec3d hips{};                   // m
  double lean = 0.0;              // rad, of the trunk
  double turn = 0.0;              // rad, of the shoulders
  double knees = 0.0;             // rad
  double swivel = 0.0;  // rad, of the reaching arm's elbow (see FinalPosture); not compared
};

// Distance of two looks (m): mean over the joints.
[[nodiscard]] double look_distance(const Look& a, const Look& b);
// Whether a person sees two looks as the same: joints nearer than kSeenDistance on average, or
// neither trunk nor knees nor hips nor an elbow elsewhere (of bodies with arms). `slack`: factor on
// all thresholds.
[[nodiscard]] bool look_alike(const Look& a, const Look& b, double slack = 1.0);
inline constexpr double kSeenDistance = 0.05;  // m
// Slack of a search, by which a replay in double precision may bring two looks nearer.
inline constexpr double kLookSlack = 1.02;

// Measures postures of one body relative to its home; `hand`: index of the effector that reaches.
// The body outlives it.
class PostureMeter {
 public:
  PostureMeter(const BodyModel& body, const State& home, int hand);

  // Measures angles (dofs, rad).
  [[nodiscard]] FinalPosture measure(std::span<const double> angles);
  // The stoop-squat index alone.
  [[nodiscard]] std::optional<double> index(std::span<const double> angles);
  [[nodiscard]] Look look(std::span<const double> angles);
  [[nodiscard]] Look look(const Clip& clip) { return look(clip.frame(clip.frames - 1)); }

 private:
  enum Place { kLeftHip, kRightHip, kLeftShoulder, kRightShoulder, kLeftElbow, kRightElbow };
  static constexpr std::size_t kPlaces = 10;  // including wrists and knees, in the same order

  [[nodiscard]] bool known(std::size_t place) const { return nodes_[place] != nullptr; }
  [[nodiscard]] Vec3d at(std::size_t place) const;
  [[nodiscard]] Vec3d between(std::size_t left) const;  // midpoint with the next, or either
  [[nodiscard]] bool is_low() const;
  [[nodiscard]] std::optional<double> index_now() const;
  [[nodiscard]] double trunk_lean() const;
  [[nodiscard]] double heading() const;
  [[nodiscard]] double elbow_swivel() const;

  const BodyModel& body_;
  std::optional<std::size_t> hand_;  // 1: the right one, 0: the left; none: no hand reaches
  std::array<const BodyNode*, kPlaces> nodes_{};
  std::vector<const BodyNode*> seen_;
  Kinematics<double> kinematics_;
  bool sits_ = false;
  double hip_height_ = 0.0;       // m, at home
  double shoulder_height_ = 0.0;  // m, at home
  double knee_height_ = 0.0;      // m, at home
  double heading_ = 0.0;          // rad, at home
};

// Whether a final posture is unnatural: folded over straight knees, crouching with the shoulders
// up, or with an elbow pointing inwards.
[[nodiscard]] bool is_strange(const FinalPosture& posture);

}  // namespace shigusa
