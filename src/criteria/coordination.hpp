// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "body/load.hpp"
#include "criteria/motion_frame.hpp"
#include "criteria/posture_points.hpp"

namespace shigusa {

// Lean (rad) about which knees begin to follow.
inline constexpr double kKneesBegin = radians(10);
// Distance (statures) of the hand from the ankles from which the knee flexion is full, and the
// share of it at distance 0.
inline constexpr double kHandAhead = 0.32;
inline constexpr double kKneesNear = 0.5;
// Heights (statures) of the hand up to which the knees bend in full, 63 cm for a man, and from
// which they do not bend: at tables people hinge.
inline constexpr double kKneesUpTo = 0.36;
inline constexpr double kKneesNoMore = 0.52;
// Relative increase of the knee flexion per kilogram of load in the hand: stoops are for light
// loads only (Burgess-Limerick and Abernethy, of 39 persons with light and heavier loads).
inline constexpr double kKneesOfLoad = 0.01;

// The flexion of the knees (rad) for a trunk's lean (rad) and a hand at the distance `far` from the
// ankles, relative to kHandAhead, per Habit::knees.
template <class S>
[[nodiscard]] S usual_knees(const S& lean, const S& far) {
  const S share = S(kKneesNear) + S(1.0 - kKneesNear) * min(far, S(1));
  return share * lean * lean / (lean + S(kKneesBegin));
}

// Penalty of a final knee flexion out of people's proportion to the trunk's lean, in [0, 1]: people
// bend both. With T the lean of the line from hips to shoulders and K the knees' flexion, q = ((K -
// K*(T)) / angle)² / 4 and P = q / (1 + q). K* keeps the posture index of R. Burgess-Limerick and
// B. Abernethy (Human Factors 39 (1997) 141), which is the same from 9 to 63 cm, and is less for a
// near load (Int. J. Industrial Ergonomics 22 (1998) 367); it is the person's habit. For higher
// hands K* fades to straight legs. A body without these joints has no penalty.
template <class S>
class Coordination {
 public:
  static constexpr CriterionKind kKind = CriterionKind::coordination;

  Coordination(const BodyModel& body, const CriteriaContext& context, double angle)
      : points_(posture_points(body, context.start)),
        hands_(goal_hands(body, context)),
        per_angle_(1.0 / angle),
        of_trunk_(context.habit.knees * (1.0 + kKneesOfLoad * heaviest_load(context.start))),
        per_ahead_(body.stature() > 0.0 ? 1.0 / (kHandAhead * body.stature()) : 0.0),
        no_more_(points_.ankles.y + kKneesNoMore * body.stature()),
        per_height_(body.stature() > 0.0 ? 1.0 / ((kKneesNoMore - kKneesUpTo) * body.stature())
                                         : 0.0) {
    for (const int d : body.dofs_of(JointKind::knee, FreedomKind::flexion)) {
      knees_.push_back(static_cast<std::size_t>(d));
    }
  }

  void reset() { off_ = S(0); }

  void add(const PlacedFrame<S>& frame) {
    if (!points_.found || knees_.empty()) return;
    const Vec3<S> line = points_.trunk(frame.kinematics);
    const S lean = max(atan2(line.z, line.y), S(0));
    Vec3<S> hand{};
    for (const GoalHand& goal : hands_) hand += goal.hand.in(frame.kinematics);
    if (!hands_.empty()) hand = hand * S(1.0 / static_cast<double>(hands_.size()));
    const S x = hand.x - S(points_.ankles.x);
    const S z = hand.z - S(points_.ankles.z);
    const S low =
        hands_.empty() ? S(1) : clamp((S(no_more_) - hand.y) * S(per_height_), S(0), S(1));
    const S knees = low * S(of_trunk_) * usual_knees(lean, sqrt(x * x + z * z) * S(per_ahead_));
    S bent(0);
    for (const std::size_t knee : knees_) bent = bent + frame.angles[knee];
    const S off = (bent * S(1.0 / static_cast<double>(knees_.size())) - knees) * S(per_angle_);
    off_ = off * off * S(0.25);
  }

  [[nodiscard]] S penalty() const { return off_ / (S(1) + off_); }

 private:
  PosturePoints points_;
  std::vector<GoalHand> hands_;
  std::vector<std::size_t> knees_;
  double per_angle_;   // 1/rad
  double of_trunk_;    // knee flexion per lean, with the load
  double per_ahead_;   // 1/m
  double no_more_;     // m, world: height of the hand from which legs are straight
  double per_height_;  // 1/m
  S off_{};            // of the last frame seen
};

}  // namespace shigusa
