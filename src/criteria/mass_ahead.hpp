// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_model.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/posture_points.hpp"

namespace shigusa {

// Of the way from the ankles to where the hands end, over the floor, the share that the centre of
// mass goes: by 5 to 14 cm in recorded low reaches, 23 to 61 % of the foot from near goals to far
// ones (Pozzo, Stapley and Papaxanthis, Exp. Brain Res. 144 (2002) 343).
inline constexpr double kMassShare = 0.18;

// Whether the centre of mass goes along with the hands where the motion ends, in [0, 1]: people do
// not hold it back. With c the way that it has gone over the floor, and g that from the middle of
// the ankles to the middle of the goals' hands, P = min(1, |c - 0.18 g|² / distance²).
template <class S>
class MassAhead {
 public:
  using Settings = MassAheadSettings;

  explicit MassAhead(const BodyModel& body, const MassAheadSettings& settings = {})
      : standing_(posture_points(body)),
        hands_(goal_hands(body, settings.effectors)),
        per_square_(1.0 / (settings.distance * settings.distance)) {}

  // Forgets the frames seen.
  void reset() {
    seen_ = false;
    penalty_ = S(0);
  }

  void add(const PlacedFrame<S>& frame) {
    if (!standing_.found || hands_.empty()) return;
    if (!seen_) start_ = frame.centre_of_mass;
    seen_ = true;
    Vec3<S> hand{};
    for (const GoalHand& goal : hands_) hand += goal.hand.in(frame.kinematics);
    const S share(kMassShare / static_cast<double>(hands_.size()));
    const S x =
        frame.centre_of_mass.x - start_.x - hand.x * share + S(standing_.standing.x * kMassShare);
    const S z =
        frame.centre_of_mass.z - start_.z - hand.z * share + S(standing_.standing.z * kMassShare);
    penalty_ = x * x + z * z;
  }

  [[nodiscard]] S penalty() const { return min(S(1), penalty_ * S(per_square_)); }

 private:
  PosturePoints standing_;
  std::vector<GoalHand> hands_;
  double per_square_;
  bool seen_ = false;
  Vec3<S> start_{};  // m
  S penalty_{};      // of the last frame seen, m²
};

}  // namespace shigusa
