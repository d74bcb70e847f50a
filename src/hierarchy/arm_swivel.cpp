// SPDX-License-Identifier: MIT
#include <array>
#include <shigusa/core/check.hpp>
#include <shigusa/hierarchy/arm_swivel.hpp>
#include <shigusa/motion/minimum_jerk.hpp>

namespace shigusa {
namespace {

// What is left of v across the unit vector u, as a unit vector.
Vec3d square_to(const Vec3d& u, const Vec3d& v) { return normalized(v - dot(u, v) * u); }

// v, square to u, after the shortest turn from u to w; both are unit vectors.
Vec3d carried(const Vec3d& v, const Vec3d& u, const Vec3d& w) {
  const double both = 1.0 + dot(u, w);
  // about half a turn any axis is as short, so v's own will do
  if (both < 1e-9) return v;
  return square_to(w, v - (dot(v, w) / both) * (u + w));
}

Vec3d turned_about(const Vec3d& axis, const Vec3d& square, double angle) {
  const SinCos<double> turn = sin_cos(angle);
  return turn.cos * square + turn.sin * cross(axis, square);
}

// Two unit vectors that are square to each other, and the third.
Mat3d frame_of(const Vec3d& along, const Vec3d& axis) { return {along, axis, cross(along, axis)}; }

}  // namespace

SwivelArm::SwivelArm(const BodyModel& arm, const BodyLimb& limb)
    : arm_(&arm), limb_(limb), outwards_(arm.dof(1).sign) {
  SHG_CHECK(arm.dof_count() == kArmDofs, "an arm has four freedoms");
  limb_.flexion = 0;
  limb_.abduction = 1;
  limb_.rotation = 2;
  limb_.hinge = 3;
}

Vec3d SwivelArm::hand_at(double bend) const {
  const double length = limb_.segments.length(bend);
  const SinCos<double> direction = sin_cos(limb_.segments.direction(bend));
  return {limb_.segments.across(), length * direction.cos, length * direction.sin};
}

double SwivelArm::run(std::span<const Vec3d> path, double swivel,
                      std::vector<double>& angles) const {
  std::array<double, kArmDofs> q{};
  std::copy(arm_->start().begin(), arm_->start().end(), q.begin());
  angles.assign(q.begin(), q.end());
  const Mat3d start = ball_rotation(limb_.turns_of(*arm_, q));
  const double across = limb_.segments.across();
  constexpr Vec3d kHinge{1, 0, 0};
  Vec3d along = normalized(start * hand_at(q[3]));
  Vec3d axis = square_to(along, start * kHinge);
  double worst = 0.0;
  for (std::size_t f = 1; f < path.size(); ++f) {
    const double distance = norm(path[f]);
    const double bend = limb_.segments.bend(sqrt(max(distance * distance - across * across, 0.0)));
    q[3] = unwrapped(bend, q[3]);
    const Vec3d hand = hand_at(q[3]);
    const double reach = norm(hand);
    const Vec3d before = along;
    // a hand in the shoulder's centre has no direction of its own
    if (distance > 1e-9) along = (1.0 / distance) * path[f];
    axis = carried(axis, before, along);
    const double tau = static_cast<double>(f) / static_cast<double>(path.size() - 1);
    const Vec3d turned = turned_about(along, axis, outwards_ * swivel * minimum_jerk(tau));
    const Vec3d own = (1.0 / reach) * hand;
    const Mat3d upper = frame_of(along, turned) * transpose(frame_of(own, square_to(own, kHinge)));
    limb_.put_turns(*arm_, ball_turns(upper, limb_.turns_of(*arm_, q)), q);
    const double miss = abs(distance - reach);
    // NaN counts as far off
    worst = miss < 1e9 ? max(worst, miss) : 1e9;
    angles.insert(angles.end(), q.begin(), q.end());
  }
  return worst;
}

}  // namespace shigusa
