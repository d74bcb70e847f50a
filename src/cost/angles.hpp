// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/cost.hpp>
#include <span>
#include <vector>

#include "criteria/posture_points.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// Lean of the trunk beyond which a home is no neutral posture.
inline constexpr double kHomeLeans = radians(20.0);

// Measures postures of one body. The body outlives it.
class AngleMeter {
 public:
  AngleMeter(const BodyModel& body, const State& home);

  // Angles of the placed body; `angles`: (dofs) rad.
  [[nodiscard]] PostureAngles measure(const Kinematics<double>& placed,
                                      std::span<const double> angles) const;
  // The middle of the ankles (m, world); empty if the body lacks them.
  [[nodiscard]] std::optional<Vec3d> ankles(const Kinematics<double>& placed) const;
  // Direction ahead of the neutral person (world, level).
  [[nodiscard]] Vec3d ahead() const { return ahead_; }
  // Direction of the line of the trunk, upwards; empty if the body lacks it.
  [[nodiscard]] std::optional<Vec3d> trunk_line(const Kinematics<double>& placed) const;
  // Whether the home was no neutral posture, and all angles at 0 are taken instead.
  [[nodiscard]] bool home_leans() const { return home_leans_; }

 private:
  struct Arm {
    LinkPoint shoulder;
    LinkPoint elbow;
    LinkPoint wrist;
    double height = 0.0;  // m, of the shoulder above C7 along the chest, neutral
    std::optional<int> flexion{};
    std::optional<int> deviation{};
    std::optional<int> rotation{};
    std::optional<int> bend{};  // flexion of the elbow
  };
  struct Leg {
    LinkPoint hip;
    LinkPoint knee;
    LinkPoint ankle;
  };
  // Axes of the trunk: x to the left, y up, z ahead, as neutral ones are.
  [[nodiscard]] std::optional<Mat3d> trunk_axes(const Kinematics<double>& placed) const;
  // Axes of a link as if it had the person's axes in the neutral posture.
  [[nodiscard]] Mat3d turned(int link, const Mat3d& neutral,
                             const Kinematics<double>& placed) const;
  [[nodiscard]] Mat3d person_axes(const Kinematics<double>& placed) const;
  [[nodiscard]] Vec3d hips(const Kinematics<double>& placed) const;
  [[nodiscard]] TrunkAngles trunk(const Kinematics<double>& placed) const;
  [[nodiscard]] ArmAngles arm(const Arm& arm, double side, const Mat3d& trunk,
                              const Kinematics<double>& placed,
                              std::span<const double> angles) const;
  void set_hand(const Arm& arm, std::span<const double> angles, ArmAngles& out) const;
  [[nodiscard]] std::optional<double> on_left(const Kinematics<double>& placed,
                                              std::span<const double> angles) const;

  const BodyModel& body_;
  std::vector<double> neutral_;
  bool home_leans_ = false;
  std::optional<LinkPoint> c7_{};
  std::optional<int> pelvis_{};
  std::optional<int> head_{};
  std::array<std::optional<Arm>, 2> arms_{};
  std::array<std::optional<Leg>, 2> legs_{};
  Mat3d pelvis_axes_{};  // R of the pelvis' link, neutral, to the person's axes
  Mat3d chest_axes_{};
  Mat3d head_axes_{};
  double lean_ = 0.0;  // rad, of the line of the trunk, neutral
  Vec3d ahead_{0, 0, 1};
};

}  // namespace shigusa
