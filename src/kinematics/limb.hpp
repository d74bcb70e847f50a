// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

#include "core/check.hpp"

namespace shigusa {

namespace limb_detail {

// Length in the y-z plane.
template <class S>
[[nodiscard]] S plane_length(const Vec3<S>& v) {
  return sqrt(v.y * v.y + v.z * v.z);
}

}  // namespace limb_detail

// Two segments with a hinge between them, in closed form: thigh and shank, upper arm and forearm.
// The hinge turns about x. In the first segment's frame the far end is at
//   end(bend) = first + Rx(sign · bend) · second,
// whose x is constant; the rest is a triangle in the y-z plane (law of cosines).
template <class S>
class BasicHingedLimb {
 public:
  // Makes a limb of the segments first, second (m), from joint to joint, each in its own frame and
  // off the x axis. sign is that of the hinge's dof: +1 if a positive angle turns about +x.
  BasicHingedLimb(const Vec3<S>& first, const Vec3<S>& second, double sign)
      : near_(limb_detail::plane_length(first)),
        far_(limb_detail::plane_length(second)),
        across_(first.x + second.x),
        sign_(static_cast<Element<S>>(sign)),
        near_turn_(atan2(first.z, first.y)),
        far_turn_(atan2(second.z, second.y)) {
    SHG_CHECK(all(near_ > S(0)) && all(far_ > S(0)), "segments of a limb have a length");
  }
  // The same limb in another scalar.
  template <class From>
  explicit BasicHingedLimb(const BasicHingedLimb<From>& limb)
      : near_(limb.near_),
        far_(limb.far_),
        across_(limb.across_),
        sign_(static_cast<Element<S>>(limb.sign_)),
        near_turn_(limb.near_turn_),
        far_turn_(limb.far_turn_) {}

  // Offset (m) of the far end from the near one along x.
  [[nodiscard]] const S& across() const { return across_; }
  // Distance (m) from end to end in the plane of the hinge.
  [[nodiscard]] S length(const S& bend) const {
    const S turn = far_turn_ - near_turn_ + S(sign_) * bend;
    const S square = near_ * near_ + far_ * far_ + S(2) * near_ * far_ * sin_cos(turn).cos;
    return sqrt(max(square, S(0)));
  }
  // The bend (rad, in 0..π for segments without offset) at which the limb has the given length in
  // the plane. Lengths out of range are clamped.
  [[nodiscard]] S bend(const S& length) const {
    const S cosine =
        (length * length - near_ * near_ - far_ * far_) * (S(1) / (S(2) * near_ * far_));
    return acos(cosine) - S(sign_) * (far_turn_ - near_turn_);
  }
  // Angle (rad, about x, 0 along +y) of the line from end to end in the first segment's frame.
  [[nodiscard]] S direction(const S& bend) const {
    const SinCos<S> first = sin_cos(near_turn_);
    const SinCos<S> second = sin_cos(far_turn_ + S(sign_) * bend);
    return atan2(near_ * first.sin + far_ * second.sin, near_ * first.cos + far_ * second.cos);
  }
  // The same angle as a function of the length (m), which is clamped as by bend().
  [[nodiscard]] S direction_of_length(const S& length) const {
    return near_turn_ + S(sign_) * acos(near_cosine(length));
  }
  // Derivative of that angle by the length (rad/m), clamped to ±most: it is unbounded as the limb
  // straightens.
  [[nodiscard]] S turn_by_length(const S& length, double most) const {
    const S cosine = near_cosine(length);
    const S along = length - near_ * cosine;
    const S height = near_ * sqrt(max((S(1) - cosine) * (S(1) + cosine), S(0)));
    const S slope = along / max(height * length, abs(along) * S(1.0 / most) + S(1e-12));
    return clamp(S(-sign_) * slope, S(-most), S(most));
  }
  // Range of lengths (m).
  [[nodiscard]] S shortest() const { return abs(near_ - far_); }
  [[nodiscard]] S longest() const { return near_ + far_; }

 private:
  template <class>
  friend class BasicHingedLimb;

  // Cosine of the angle between the first segment and the line from end to end.
  [[nodiscard]] S near_cosine(const S& length) const {
    const S cosine =
        (near_ * near_ + length * length - far_ * far_) / max(S(2) * near_ * length, S(1e-9));
    return clamp(cosine, S(-1), S(1));
  }

  S near_;           // m, length of the first segment in the plane
  S far_;            // m, length of the second segment
  S across_;         // m
  Element<S> sign_;  // of the hinge
  S near_turn_;      // rad, about x: direction of the first segment in its own frame
  S far_turn_;       // rad, of the second segment in its own frame
};
using HingedLimb = BasicHingedLimb<double>;

// Turn about z (rad) that brings the plane of constant x = `across` through the point `far` of
// positive y: the inversion of an ankle whose leg plane passes through the hip. For a point nearer
// to the z axis than `across`, the plane comes as near as it can.
template <class S>
[[nodiscard]] S plane_turn(const Vec3<S>& far, const S& across) {
  const S away = sqrt(far.x * far.x + far.y * far.y);
  return atan2(far.y, far.x) - acos(across / max(away, abs(across)));
}

// The angle plus whole turns nearest to `near` (rad); |angle - near| below 1e6.
template <class S>
[[nodiscard]] S unwrapped(const S& angle, const S& near) {
  return angle + nearest_integer((near - angle) * S(0.5 / kPi)) * S(kTwoPi);
}

// Angles of a body's ball joint, with the relative rotation R = Rx(x) · Rz(z) · Ry(y) from the
// carrying link to the limb (or its transpose, if the limb carries the trunk).
template <class S>
struct BasicBallTurns {
  S x{};  // rad
  S z{};
  S y{};
};
using BallTurns = BasicBallTurns<double>;

template <class S>
[[nodiscard]] Mat3<S> ball_rotation(const BasicBallTurns<S>& turns) {
  const Mat3<S> flexed = rotated(Mat3<S>{}, Axis::x, sin_cos(turns.x));
  return rotated(rotated(flexed, Axis::z, sin_cos(turns.z)), Axis::y, sin_cos(turns.y));
}

namespace limb_detail {

// Bound of cos z near z = 90°, where x and y turn about one line.
template <class S>
inline constexpr double kOneLine = sizeof(Element<S>) == sizeof(double) ? 1e-9 : 1e-5;

// The turns of r for a given x, nearest to `near`; `flexed`: sine and cosine of x.
template <class S>
[[nodiscard]] BasicBallTurns<S> turns_with(const S& x, const SinCos<S>& flexed, const Mat3<S>& r,
                                           const BasicBallTurns<S>& near) {
  const S z = atan2(-r.cy.x, flexed.cos * r.cy.y + flexed.sin * r.cy.z);
  const S y =
      atan2(flexed.sin * r.cx.y - flexed.cos * r.cx.z, flexed.cos * r.cz.z - flexed.sin * r.cz.y);
  return {unwrapped(x, near.x), unwrapped(z, near.z), unwrapped(y, near.y)};
}

}  // namespace limb_detail

// The turns of the rotation R; among all solutions the one with angles nearest to `near`, so that a
// moving joint's angles do not jump. If z is 90° to within rounding, x and y turn about one line,
// and x is near.x.
template <class S>
[[nodiscard]] BasicBallTurns<S> ball_turns(const Mat3<S>& r, const BasicBallTurns<S>& near = {}) {
  // the second column is Rx(x) · (-sin z, cos z, 0)
  const S across = limb_detail::plane_length(r.cy);
  const auto one_line = across < S(limb_detail::kOneLine<S>);
  const S divided = max(across, S(limb_detail::kOneLine<S>));
  SinCos<S> flexed{r.cy.z / divided, r.cy.y / divided};
  S x = atan2(r.cy.z, r.cy.y);
  if (any(one_line)) {
    const SinCos<S> kept = sin_cos(near.x);
    flexed = {select(one_line, kept.sin, flexed.sin), select(one_line, kept.cos, flexed.cos)};
    x = select(one_line, near.x, x);
  }
  const auto distance = [&near](const BasicBallTurns<S>& b) {
    return abs(b.x - near.x) + abs(b.z - near.z) + abs(b.y - near.y);
  };
  const BasicBallTurns<S> one = limb_detail::turns_with(x, flexed, r, near);
  const S off = distance(one);
  if (!any(off >= S(0.5 * kPi))) return one;
  // the second solution has x + π
  const BasicBallTurns<S> other =
      limb_detail::turns_with<S>(x + S(kPi), {-flexed.sin, -flexed.cos}, r, near);
  const auto nearer = (distance(other) < off) & !one_line;
  return {select(nearer, other.x, one.x), select(nearer, other.z, one.z),
          select(nearer, other.y, one.y)};
}

// Rule R4: range of a pelvis by the limits of ankle and knee. The line from ankle to hip, in the
// plane of the leg, has a lean (rad, about the ankle's axis, forwards) and a length (m).
class PelvisRange {
 public:
  struct Limits {
    double ankle_lower;  // rad
    double ankle_upper;
    double knee_lower;
    double knee_upper;
  };
  // `leg` goes up from the ankle: shank, then thigh; its direction leans back as the knee bends.
  PelvisRange(const HingedLimb& leg, const Limits& limits);

  // Leg lengths (m) at the knee's two limits.
  [[nodiscard]] double shortest() const { return shortest_; }
  [[nodiscard]] double longest() const { return longest_; }
  // Excess (rad) of ankle or knee over its limit, whichever is larger, at this lean and length; 0
  // within. A leg stretched beyond its length counts as the angle whose tangent is the gap over the
  // length.
  [[nodiscard]] double excess(double lean, double length) const;

 private:
  HingedLimb leg_;
  Limits limits_;
  double shortest_;
  double longest_;
};

}  // namespace shigusa
