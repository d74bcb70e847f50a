// SPDX-License-Identifier: MIT
#include "human/at_ease.hpp"
#include "landmark_points.hpp"
#include "moved_limbs.hpp"

namespace shigusa {
namespace {

// Bends a leg for a lowered hip: shank vertical over a flat foot, and the thigh to the resulting
// knee. A thigh that would slope too much is put at its limit: on a high seat the foot hangs, on a
// low one it stands farther ahead.
void bend_over_seat(Landmarks::Leg& leg, const Vec3d& hip) {
  constexpr double kDown = 0.5;  // of the thigh's length, from hip to knee
  constexpr double kUp = 0.8;
  const LegLengths length(leg);
  const Vec3d ankle = leg.ankle;
  const Vec3d sole = leg.toe - leg.ankle;
  const Vec3d ahead = normalized(Vec3d{sole.x, 0.0, sole.z}, {0, 0, 1});
  const double wanted = leg.ankle.y + length.shank - hip.y;
  const double rise = clamp(wanted, -kDown * length.thigh, kUp * length.thigh);
  const double forwards = sqrt(length.thigh * length.thigh - rise * rise);
  const double foot = min(hip.y + rise - leg.ankle.y, length.shank);  // height of the knee above it
  const double on = sqrt(max(length.shank * length.shank - foot * foot, 0.0));
  leg.hip = hip;
  leg.knee = hip + ahead * forwards + Vec3d{0, rise, 0};
  leg.ankle = leg.knee + ahead * on - Vec3d{0, foot, 0};
  move_foot(leg, ankle);
}

}  // namespace

Landmarks seated(const Landmarks& person, double stature, double seat) {
  Landmarks result = person;
  const double drop = mid_hip(person).y - (seat + kSeatedHip * stature);
  const auto between_feet = [](const Landmarks& p) {
    const Vec3d sum = p.left_leg.ankle + p.right_leg.ankle;
    return Vec3d{0.5 * sum.x, 0.0, 0.5 * sum.z};
  };
  for (const Side side : kBothSides) {
    bend_over_seat(result.leg(side), person.leg(side).hip - Vec3d{0.0, drop, 0.0});
  }
  move_upper_body(result, {0.0, -drop, 0.0});
  const SinCos<double> slope = sin_cos(kSeatedForearms);
  lay_arms(result, person, {0, -1, 0}, {0.0, -slope.sin, slope.cos});
  // the feet stay in place
  const Vec3d back = between_feet(person) - between_feet(result);
  move_upper_body(result, back);
  for (const Side side : kBothSides) {
    Landmarks::Leg& leg = result.leg(side);
    const Vec3d ankle = leg.ankle;
    for (Vec3d* p : {&leg.hip, &leg.knee, &leg.ankle}) *p += back;
    move_foot(leg, ankle);
  }
  return result;
}

}  // namespace shigusa
