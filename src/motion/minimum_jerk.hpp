// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

namespace shigusa {

// The minimum-jerk profile s(τ) = 10τ³ - 15τ⁴ + 6τ⁵ for τ in [0, 1] (clamped): from 0 to 1 at rest
// at both ends. Source: T. Flash and N. Hogan, J. Neuroscience 5 (1985) 1688-1703.
template <class S>
[[nodiscard]] S minimum_jerk(const S& tau) {
  const S t = clamp(tau, S(0), S(1));
  return t * t * t * (S(10) - t * (S(15) - S(6) * t));
}

// Share of its own time that a movement has completed at tau, with a `haste` of its first half over
// its second: τ + 4 haste · τ² (1 - τ)², in -1..1. The ends are as gentle as without haste. With
// the minimum-jerk profile the velocity peaks at tau = 0.50 for a haste of 0, 0.41 for 0.22, and
// 0.57 for -0.15.
template <class S>
[[nodiscard]] constexpr S hastened(const S& tau, const S& haste) {
  const S bump = tau * (S(1) - tau);
  return tau + S(4) * haste * bump * bump;
}

// Displacement at τ in [0, 1] of the smoothest movement that begins with a velocity and ends where
// it began, as a share of that velocity times the duration: τ - 6τ³ + 8τ⁴ - 3τ⁵. Added to a
// minimum-jerk line it gives the path of least jerk from a moving start (Flash and Hogan 1985).
[[nodiscard]] constexpr double carried_on(double tau) {
  return tau * (1.0 - tau * tau * (6.0 - tau * (8.0 - 3.0 * tau)));
}

// A profile from 0 to 1 for τ in [0, 1] (clamped) with zero jerk at both ends, for motions that
// would jolt the body: 35τ⁴ - 84τ⁵ + 70τ⁶ - 20τ⁷.
template <class S>
[[nodiscard]] S minimum_snap(const S& tau) {
  const S t = clamp(tau, S(0), S(1));
  const S square = t * t;
  return square * square * (S(35) - t * (S(84) - t * (S(70) - S(20) * t)));
}

// Share of the remaining change made in a step: `before` and `now` are the shares of the whole
// change completed before and after the step.
[[nodiscard]] constexpr double share_of_rest(double before, double now) {
  return before < 1.0 ? (now - before) / (1.0 - before) : 1.0;
}

// The minimum-jerk detour: 1 at τ = peak, at rest at 0 for τ = 0 and 1 (clamped). Added to a
// minimum-jerk line it gives the path of least jerk through a via point (Flash and Hogan 1985): a
// quintic whose fifth derivative jumps at the peak. peak in (0, 1).
[[nodiscard]] constexpr double minimum_jerk_detour(double tau, double peak) {
  const double u = 1.0 - peak;
  // a3 t³ + a4 t⁴ + a5 t⁵ + (t - peak)₊⁵ and its first two derivatives vanish at t = 1
  const double end = -u * u * u * u * u;
  const double end_speed = -5.0 * u * u * u * u;
  const double end_acceleration = -20.0 * u * u * u;
  const double a3 = 10.0 * end - 4.0 * end_speed + 0.5 * end_acceleration;
  const double a4 = -15.0 * end + 7.0 * end_speed - end_acceleration;
  const double a5 = 6.0 * end - 3.0 * end_speed + 0.5 * end_acceleration;
  const auto rise = [&](double t) { return t * t * t * (a3 + t * (a4 + t * a5)); };
  const double t = tau < 0.0 ? 0.0 : tau > 1.0 ? 1.0 : tau;
  // the terms cancel exactly there
  if (t >= 1.0) return 0.0;
  const double late = t > peak ? t - peak : 0.0;
  return (rise(t) + late * late * late * late * late) / rise(peak);
}

// Offset of a bowed path from its line at the share s of the line, for a bow of 1: 4 s (1 - s),
// with a skew of up to ±1 more of it early (> 0) or late (< 0).
template <class S>
[[nodiscard]] S path_bow(const S& s, const S& skew) {
  return S(4) * s * (S(1) - s) * (S(1) + skew * (S(1) - S(2) * s));
}

// Path of an effector over time: a minimum-jerk line from start to goal, straight or with a detour.
struct EffectorPath {
  Vec3d start{};             // m, world
  Vec3d goal{};              // m, world
  Vec3d detour{};            // m, world: offset of the path from the straight line at its peak
  double detour_peak = 0.5;  // in (0, 1): time of the peak, as a share of the path's own time
  double begin = 0.0;        // share of the duration before the effector leaves
  double haste = 0.0;        // see hastened()
  Vec3d momentum{};          // m, world: velocity at the start times the duration

  // Share of the path's own time elapsed at tau = time / duration in [0, 1].
  [[nodiscard]] double own_time(double tau) const {
    return tau > begin ? hastened((tau - begin) / (1.0 - begin), haste) : 0.0;
  }
  // Position (m, world) at tau.
  [[nodiscard]] Vec3d at(double tau) const {
    const Vec3d line = start + (goal - start) * done(tau) +
                       detour * minimum_jerk_detour(own_time(tau), detour_peak);
    return momentum == Vec3d{} ? line : line + momentum * carried_on(tau);
  }
  // Share of the line covered at tau.
  [[nodiscard]] double done(double tau) const { return minimum_jerk(own_time(tau)); }
};

// Rule R9: T = clamp(0.45 s + 0.75 s/m · D, 0.6 s, 2.0 s), and 0.14 s more if trunk and legs must
// help (Bertucco, Cesari and Latash 2013).
inline constexpr double kDurationBase = 0.45;      // s
inline constexpr double kDurationPerMetre = 0.75;  // s/m
inline constexpr double kDurationMin = 0.6;        // s
inline constexpr double kDurationMax = 2.0;        // s
inline constexpr double kDurationTrunk = 0.14;     // s

// Factor on the duration of a reach with a load (kg) in the hand: the weight factor of MTM-1
// (Methods-Time Measurement, H. Maynard, G. Stegemerten and J. Schwab, 1948), from 1.00 at 2.5 lb
// to 1.50 at 47.5 lb in even steps.
inline constexpr double kFreeLoad = 1.13;   // kg
inline constexpr double kPerLoad = 0.0245;  // 1/kg
[[nodiscard]] constexpr double load_factor(double load) {
  return 1.0 + kPerLoad * (load > kFreeLoad ? load - kFreeLoad : 0.0);
}

// Duration (s) of a reach over `distance` (m).
[[nodiscard]] inline double reach_duration(double distance, bool needs_trunk) {
  return clamp(kDurationBase + kDurationPerMetre * distance, kDurationMin, kDurationMax) +
         (needs_trunk ? kDurationTrunk : 0.0);
}

}  // namespace shigusa
