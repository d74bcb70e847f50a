// SPDX-License-Identifier: MIT
#include "kinematics/limb.hpp"

#include "core/check.hpp"

namespace shigusa {
namespace {

// In the y-z plane.
double plane_length(const Vec3d& v) { return sqrt(v.y * v.y + v.z * v.z); }

}  // namespace

HingedLimb::HingedLimb(const Vec3d& first, const Vec3d& second, double sign)
    : near_(plane_length(first)),
      far_(plane_length(second)),
      across_(first.x + second.x),
      sign_(sign),
      near_turn_(atan2(first.z, first.y)),
      far_turn_(atan2(second.z, second.y)) {
  SHG_CHECK(near_ > 0.0 && far_ > 0.0, "segments of a limb have a length");
}

double HingedLimb::length(double bend) const {
  const double turn = far_turn_ - near_turn_ + sign_ * bend;
  const double square = near_ * near_ + far_ * far_ + 2.0 * near_ * far_ * sin_cos(turn).cos;
  return sqrt(max(square, 0.0));
}

double HingedLimb::bend(double length) const {
  const double cosine =
      (length * length - near_ * near_ - far_ * far_) * (1.0 / (2.0 * near_ * far_));
  return acos(cosine) - sign_ * (far_turn_ - near_turn_);
}

double HingedLimb::direction(double bend) const {
  const SinCos<double> first = sin_cos(near_turn_);
  const SinCos<double> second = sin_cos(far_turn_ + sign_ * bend);
  return atan2(near_ * first.sin + far_ * second.sin, near_ * first.cos + far_ * second.cos);
}

double plane_turn(const Vec3d& far, double across) {
  const double away = sqrt(far.x * far.x + far.y * far.y);
  return atan2(far.y, far.x) - acos(across / max(away, abs(across)));
}

Mat3d ball_rotation(const BallTurns& turns) {
  const Mat3d flexed = rotation(Axis::x, turns.x);
  return rotated(rotated(flexed, Axis::z, sin_cos(turns.z)), Axis::y, sin_cos(turns.y));
}

double unwrapped(double angle, double near) {
  // adding and subtracting 1.5·2^52 rounds to the nearest integer
  constexpr double kRound = 6755399441055744.0;
  const double turns = ((near - angle) * (0.5 / kPi) + kRound) - kRound;
  return angle + turns * (2.0 * kPi);
}

BallTurns ball_turns(const Mat3d& r, const BallTurns& near) {
  // the second column is Rx(x) · (-sin z, cos z, 0)
  const double across = plane_length(r.cy);
  const auto with_x = [&](double x) {
    const Mat3d rest = rotation(Axis::x, -x) * r;
    return BallTurns{unwrapped(x, near.x), unwrapped(atan2(-rest.cy.x, rest.cy.y), near.z),
                     unwrapped(atan2(-rest.cx.z, rest.cz.z), near.y)};
  };
  if (across < 1e-9) return with_x(near.x);
  const auto distance = [&near](const BallTurns& b) {
    return abs(b.x - near.x) + abs(b.z - near.z) + abs(b.y - near.y);
  };
  const double x = atan2(r.cy.z, r.cy.y);
  const BallTurns one = with_x(x);
  // the other way has another x by half a turn
  if (distance(one) < 0.5 * kPi) return one;
  const BallTurns other = with_x(x + kPi);
  return distance(other) < distance(one) ? other : one;
}

PelvisRange::PelvisRange(const HingedLimb& leg, const Limits& limits)
    : leg_(leg),
      limits_(limits),
      shortest_(leg.length(limits.knee_upper)),
      longest_(leg.length(limits.knee_lower)) {}

double PelvisRange::excess(double lean, double length) const {
  const double knee = leg_.bend(length);
  const double ankle = lean - leg_.direction(knee);
  const double gap = max(length - leg_.longest(), leg_.shortest() - length);
  double most = gap > 0.0 ? atan2(gap, leg_.longest()) : 0.0;
  for (const double over : {knee - limits_.knee_upper, limits_.knee_lower - knee,
                            ankle - limits_.ankle_upper, limits_.ankle_lower - ankle}) {
    most = max(most, over);
  }
  return most;
}

}  // namespace shigusa
