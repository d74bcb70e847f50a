// SPDX-License-Identifier: MIT
#include "moving_body.hpp"

#include <algorithm>

namespace shigusa::bench {
namespace {

constexpr double kWeight = 9.80665;  // m/s²

// rad/s, midway between two frames
Vec3d turning(const Mat3d& from, const Mat3d& to, double time) {
  return rotation_vector(to * transpose(from)) * (1.0 / time);
}

Wrench piece_wrench(const MovingPiece& piece, std::size_t before, std::size_t now,
                    std::size_t after, double time) {
  const Vec3d& c = piece.centre[now];
  const Vec3d acceleration =
      (piece.centre[after] - c * 2.0 + piece.centre[before]) * (1.0 / (time * time));
  const Vec3d force = (acceleration + Vec3d{0.0, kWeight, 0.0}) * piece.mass;
  const Vec3d earlier = turning(piece.turn[before], piece.turn[now], time);
  const Vec3d later = turning(piece.turn[now], piece.turn[after], time);
  const Mat3d inertia = piece.turn[now] * piece.inertia * transpose(piece.turn[now]);
  const Vec3d spin = (earlier + later) * 0.5;
  const Vec3d moment = inertia * ((later - earlier) * (1.0 / time)) + cross(spin, inertia * spin);
  return {force, cross(c, force) + moment};
}

}  // namespace

std::vector<Wrench> piece_wrenches(const MovingBody& body) {
  std::vector<Wrench> wrenches;
  for (int f = 0; f < body.frames; ++f) {
    const auto before = static_cast<std::size_t>(std::max(f - 1, 0));
    const auto after = static_cast<std::size_t>(std::min(f + 1, body.frames - 1));
    for (const MovingPiece& piece : body.pieces) {
      wrenches.push_back(
          piece_wrench(piece, before, static_cast<std::size_t>(f), after, body.frame_time));
    }
  }
  return wrenches;
}

std::vector<double> hinge_torque(const MovingBody& body, const std::vector<Wrench>& wrenches,
                                 const MovingHinge& hinge) {
  std::vector<double> torque;
  for (std::size_t f = 0; f < static_cast<std::size_t>(body.frames); ++f) {
    Wrench sum;
    for (const std::size_t piece : hinge.carries) {
      const Wrench& of = wrenches[f * body.pieces.size() + piece];
      sum = {sum.force + of.force, sum.moment + of.moment};
    }
    for (const MovingForce& push : body.forces) {
      if (std::find(hinge.carries.begin(), hinge.carries.end(), push.piece) ==
          hinge.carries.end()) {
        continue;
      }
      sum = {sum.force - push.force[f], sum.moment - cross(push.at[f], push.force[f])};
    }
    torque.push_back(dot(hinge.axis[f], sum.moment - cross(hinge.at[f], sum.force)));
  }
  return torque;
}

std::vector<Wrench> floor_wrenches(const MovingBody& body, const std::vector<Wrench>& wrenches) {
  std::vector<Wrench> floor;
  for (std::size_t f = 0; f < static_cast<std::size_t>(body.frames); ++f) {
    Wrench sum;
    for (std::size_t k = 0; k < body.pieces.size(); ++k) {
      const Wrench& of = wrenches[f * body.pieces.size() + k];
      sum = {sum.force + of.force, sum.moment + of.moment};
    }
    for (const MovingForce& push : body.forces) {
      sum = {sum.force - push.force[f], sum.moment - cross(push.at[f], push.force[f])};
    }
    floor.push_back(sum);
  }
  return floor;
}

}  // namespace shigusa::bench
