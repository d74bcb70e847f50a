// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <vector>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// Height (m) of a thing above its place at which it counts as lifted: a little less than the lift
// of generated work.
inline constexpr double kLifted = 0.045;
// Distance (m) of a hand's point from what its palm lies on, at most.
inline constexpr double kPalm = 0.04;

// Frames of a clip, both included.
struct Frames {
  int from = 0;
  int to = 0;
};

// The ways of a body's parts in a clip. Borrows both.
class RecordedWay {
 public:
  RecordedWay(const BodyModel& body, const Clip& clip) : body_(body), clip_(clip) {}

  [[nodiscard]] Kinematics<double> placed(int frame) const;
  // Pose of an effector's link, and place of its point (world).
  [[nodiscard]] Transformd place(int effector, int frame) const;
  [[nodiscard]] Vec3d at(int effector, int frame) const;

  // The first frame in which a distance (m) is small and the effectors are slowest, or else the one
  // of the least distance. `rests`: whether they must be slow.
  [[nodiscard]] int settles(std::span<const int> effectors, Frames frames, bool rests,
                            const std::function<double(int)>& distance) const;
  // Hips and head, where they are effectors.
  [[nodiscard]] std::vector<int> upright_parts() const;
  // The first frame in which hips and head are about as high as at home and slowest.
  [[nodiscard]] int rise(const PosedBody& posed, Frames frames) const;

 private:
  // Greatest speed (m/s) of the effectors.
  [[nodiscard]] double speed(std::span<const int> effectors, int frame) const;

  const BodyModel& body_;
  const Clip& clip_;
};

}  // namespace shigusa
