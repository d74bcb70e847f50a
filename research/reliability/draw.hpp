// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>
#include <vector>

namespace shigusa::bench {

// Random numbers of one task.
class Draw {
 public:
  Draw(std::uint64_t stream, std::uint64_t number) : random_(stream, number) {}

  double within(double low, double high) { return random_.uniform(low, high); }
  bool in(double share) { return random_.uniform() < share; }
  template <class T>
  const T& one_of(const std::vector<T>& list) {
    const double at = random_.uniform() * static_cast<double>(list.size());
    return list[static_cast<std::size_t>(at)];
  }
  Vec3d in_box(const Vec3d& low, const Vec3d& high) {
    return {within(low.x, high.x), within(low.y, high.y), within(low.z, high.z)};
  }
  Quatd turn() {
    const Quatd q{within(-1, 1), within(-1, 1), within(-1, 1), within(-1, 1)};
    const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x / length, q.y / length, q.z / length, q.w / length};
  }

 private:
  Random random_;
};

}  // namespace shigusa::bench
