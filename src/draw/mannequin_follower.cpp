// SPDX-License-Identifier: MIT
#include "mannequin_follower.hpp"

namespace shigusa {
namespace {

// Twist beyond which less of it is taken back, as its sign is ambiguous at half a turn.
constexpr double kFullTwist = 1.9;  // rad
// Angles of a limb from hanging between which the twist fades; near the upper one it is undefined.
constexpr double kHighSwing[] = {1.9, 2.8};  // rad

double smooth(double low, double high, double x) {
  const double t = clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Quatd conjugate(const Quatd& q) { return {-q.x, -q.y, -q.z, q.w}; }

// Twist of a rotation about an axis (rad, -π to π).
double twist_angle(const Quatd& turn, const Vec3d& axis) {
  const double about = turn.x * axis.x + turn.y * axis.y + turn.z * axis.z;
  const double angle = 2.0 * atan2(about, turn.w);
  return angle > kPi ? angle - kTwoPi : angle < -kPi ? angle + kTwoPi : angle;
}

Quatd half_of(const Quatd& turn) {
  const Quatd q = nearer(turn, {});
  const double over = 1.0 / sqrt(2.0 + 2.0 * q.w);
  return {q.x * over, q.y * over, q.z * over, (1.0 + q.w) * over};
}

}  // namespace

Quatd axis_turn(const Vec3d& axis, double angle) {
  const SinCos<double> half = sin_cos(0.5 * angle);
  return {axis.x * half.sin, axis.y * half.sin, axis.z * half.sin, half.cos};
}

Quatd MannequinFollower::follow(const Quatd& joint_turn) const {
  const Quatd hanging = conjugate(above) * joint_turn * turn;
  switch (kind) {
    case SkinBone::Kind::half:
      return above * half_of(untwisted(hanging, 1.0));
    case SkinBone::Kind::swing:
      return above * untwisted(hanging, 1.0);
    default:
      return above * untwisted(hanging, 0.5);
  }
}

// Rotation with a share of its twist about the limb removed.
Quatd MannequinFollower::untwisted(const Quatd& turned, double share) const {
  const double twist = twist_angle(turned, down);
  const Quatd swung = turned * axis_turn(down, -twist);
  const double swing = 2.0 * acos(abs(swung.w));
  const double kept = abs(twist) < kFullTwist ? 1.0 : (kPi - abs(twist)) / (kPi - kFullTwist);
  const double known = 1.0 - smooth(kHighSwing[0], kHighSwing[1], swing);
  return turned * axis_turn(down, -twist * share * kept * known);
}

double finger_bend(const SkinBone& finger, double closed) {
  const auto [open, relaxed, grip] = finger.bends;
  return relaxed + (closed < 0.0 ? relaxed - open : grip - relaxed) * closed;
}

double hand_closed(double share) {
  return -0.9 * smooth(0.08, 0.5, share) + 1.35 * smooth(0.74, 1.0, share);
}

}  // namespace shigusa
