// SPDX-License-Identifier: MIT
#include "motion/effector_turn.hpp"

#include "motion/minimum_jerk.hpp"

namespace shigusa {
namespace {

// A rotation with x along a direction.
Mat3d pointing(const Vec3d& direction) {
  const Vec3d beside = abs(direction.x) > 0.7 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  const Vec3d z = normalized(cross(direction, beside));
  return {direction, cross(z, direction), z};
}

}  // namespace

Mat3d EffectorTurn::at(double tau) const {
  const double share = minimum_jerk(tau);
  if (kind == Turning::whole) {
    const Vec3d turn = rotation_vector(goal * transpose(start));
    return share < 1.0 ? rotation_by(turn * share) * start : goal;
  }
  if (kind == Turning::free) return start;
  const Vec3d from = start * axis;
  return pointing(share < 1.0 ? rotation_by(turn_between(from, direction) * share) * from
                              : direction);
}

EffectorTurn EffectorTurn::ending_at(const Mat3d& orientation) const {
  EffectorTurn turn = *this;
  turn.goal = orientation;
  turn.direction = normalized(orientation * axis);
  return turn;
}

}  // namespace shigusa
