// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/posture_points.hpp"

namespace shigusa {

// How far people's hands leave the straight way forwards, as shares of its length: on a level way
// by the first, and by the second more on the way straight down, less on the way straight up.
// Recorded: 0.05 to 0.17 down to the floor, -0.03 to -0.07 up to shelves.
inline constexpr double kBowLevel = 0.03;
inline constexpr double kBowDown = 0.08;
// The mean over a motion's time of how far a bow of 1 has left its line (see path_bow): ∫ 4 s (1 -
// s) along the minimum-jerk profile.
inline constexpr double kMeanBow = 0.4329;

// How the hands' paths leave the straight way, in [0, 1]: people's hands do by some tenth of it,
// each in its direction. Of each goal's hand, o is the mean offset of its places from the middle of
// its straight way, square to that and over the bow's mean share of time, and n the offset that
// people's have, m = mean |o - n|² / offset² and P = m / (1 + m): far from people's way, too,
// nearer is better. A hand that moves by less than 5 cm, and a body without hands, has no penalty.
template <class S>
class HandCurve {
 public:
  using Settings = HandCurveSettings;

  explicit HandCurve(const BodyModel& body, const HandCurveSettings& settings = {})
      : hands_(goal_hands(body, settings.effectors)),
        sums_(hands_.size()),
        starts_(sums_),
        ends_(sums_),
        per_square_(1.0 / (settings.offset * settings.offset)) {}

  // Forgets the frames seen.
  void reset() { frames_ = 0; }

  void add(const PlacedFrame<S>& frame) {
    for (std::size_t h = 0; h < hands_.size(); ++h) {
      ends_[h] = hands_[h].hand.in(frame.kinematics);
      if (frames_ == 0) {
        starts_[h] = ends_[h];
        sums_[h] = ends_[h] * S(0.5);
      } else {
        sums_[h] += ends_[h];
      }
    }
    frames_ += 1;
  }

  [[nodiscard]] S penalty() const {
    if (frames_ == 0 || hands_.empty()) return S(0);
    S sum(0);
    for (std::size_t h = 0; h < hands_.size(); ++h) sum = sum + square_off(h);
    const S off = sum * S(per_square_ / static_cast<double>(hands_.size()));
    return off / (S(1) + off);
  }

 private:
  [[nodiscard]] S square_off(std::size_t h) const {
    const Vec3<S> way = ends_[h] - starts_[h];
    const S length = max(norm(way), S(1e-6));
    const Vec3<S> along = way * (S(1) / length);
    // both ends count half
    Vec3<S> off = (sums_[h] - ends_[h] * S(0.5)) * S(1.0 / max(frames_ - 1, 1)) -
                  (starts_[h] + ends_[h]) * S(0.5);
    off = (off - along * dot(off, along)) * (S(1.0 / kMeanBow) / length);
    // forwards, square to the way; a way that leads forwards bows nowhere
    const Vec3<S> forward = Vec3<S>{S(0), S(0), S(1)} - along * along.z;
    off = off - forward * (S(kBowLevel) - S(kBowDown) * along.y);
    return select(length > S(0.05), dot(off, off), S(0));
  }

  std::vector<GoalHand> hands_;
  std::vector<Vec3<S>> sums_;    // m, of places
  std::vector<Vec3<S>> starts_;  // m
  std::vector<Vec3<S>> ends_;    // m
  double per_square_;
  int frames_ = 0;
};

}  // namespace shigusa
