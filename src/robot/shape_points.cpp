// SPDX-License-Identifier: MIT
#include "shape_points.hpp"

namespace shigusa {
namespace {

using Kind = Robot::Shape::Kind;

class SurfacePoints {
 public:
  SurfacePoints(const Robot::Shape& shape, double apart, int most)
      : shape_(shape), apart_(apart), most_(most) {
    switch (shape.kind) {
      case Kind::box:
        add_box();
        break;
      case Kind::cylinder:
        add_cylinder();
        break;
      case Kind::ball:
        add_ball();
        break;
    }
  }

  [[nodiscard]] std::vector<Vec3d> take() { return std::move(points_); }

 private:
  // Number of points along a length.
  [[nodiscard]] int steps(double length, int least) const {
    const double even = clamp(length / apart_, 0.0, static_cast<double>(most_));
    return std::max(static_cast<int>(even + 0.5), least);
  }
  // Centre of the k-th of `count` pieces of -1..1.
  static double middle(int k, int count) { return (2.0 * k + 1.0) / count - 1.0; }

  void add(const Vec3d& own) { points_.push_back(shape_.place * own); }

  void add_box() {
    const Vec3d& half = shape_.half;
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const int along = steps(2.0 * half[u], 2);
      const int across = steps(2.0 * half[v], 2);
      for (int i = 0; i < along * across; ++i) {
        Vec3d p{};
        p[u] = half[u] * middle(i % along, along);
        p[v] = half[v] * middle(i / along, across);
        for (const double side : {half[axis], -half[axis]}) {
          p[axis] = side;
          add(p);
        }
      }
    }
  }

  // Adds a circle about z.
  void add_ring(double radius, double height) {
    constexpr int kFewest = 8;
    const int count = steps(kTwoPi * radius, kFewest);
    for (int k = 0; k < count; ++k) {
      const SinCos<double> towards = sin_cos(kTwoPi * (k + 0.5) / count);
      add({radius * towards.cos, radius * towards.sin, height});
    }
  }

  void add_cylinder() {
    const double radius = shape_.half.x;
    const double end = shape_.half.z;
    const int along = steps(2.0 * end, 2);
    for (int k = 0; k < along; ++k) add_ring(radius, end * middle(k, along));
    const int rings = steps(radius, 1);
    for (int k = 0; k < rings; ++k) {
      for (const double height : {end, -end}) add_ring(radius * (k + 0.5) / rings, height);
    }
  }

  void add_ball() {
    const double radius = shape_.half.x;
    const int rings = steps(kPi * radius, 4);
    for (int k = 0; k < rings; ++k) {
      const SinCos<double> polar = sin_cos(kPi * (k + 0.5) / rings);
      add_ring(radius * polar.sin, radius * polar.cos);
    }
  }

  const Robot::Shape& shape_;
  double apart_;
  int most_;
  std::vector<Vec3d> points_;
};

}  // namespace

std::vector<Vec3d> surface_points(const Robot::Shape& shape, double apart, int most) {
  const Vec3d& half = shape.half;
  if (!(min(min(half.x, half.y), half.z) > 0.0)) return {};
  return SurfacePoints(shape, apart, most).take();
}

}  // namespace shigusa
