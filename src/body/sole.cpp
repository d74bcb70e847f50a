// SPDX-License-Identifier: MIT
#include "body/sole.hpp"

#include <algorithm>

namespace shigusa {

double Sole::least_height(const Mat3d& turn) const {
  double lowest = 0.0;  // the point itself is not below the floor either
  for (const Vec3d& corner : corners) lowest = min(lowest, (turn * corner).y);
  return floor - lowest;
}

double Sole::least_height(const Vec3d& axis, const Vec3d& direction) const {
  // Number of rotations tried. A corner's height is the cosine of the angle about the axis; steps
  // of some 1° find the minimum of the maximum to a tenth of a millimetre.
  constexpr int kTurns = 360;
  const Vec3d beside = abs(axis.x) > 0.7 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  const Vec3d u = normalized(cross(axis, beside));
  const Vec3d v = cross(axis, u);
  const double level = sqrt(max(1.0 - direction.y * direction.y, 0.0));
  double least = 1e9;
  for (int k = 0; k < kTurns; ++k) {
    const SinCos<double> turn = sin_cos(k * 2.0 * kPi / kTurns);
    double lowest = 0.0;
    for (const Vec3d& corner : corners) {
      const double about = dot(corner, u) * turn.cos + dot(corner, v) * turn.sin;
      lowest = min(lowest, dot(corner, axis) * direction.y + about * level);
    }
    least = min(least, -lowest);
  }
  return floor + least;
}

Sole sole_under(const Foot& foot, const Vec3d& point, const Transformd& start) {
  Sole sole;
  for (const Vec3d& corner : foot.heel ? foot.heel->forefoot : foot.outline) {
    sole.corners.push_back(corner - point);
    sole.floor = min(sole.floor, (start * corner).y);
  }
  return sole;
}

}  // namespace shigusa
