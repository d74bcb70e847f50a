// SPDX-License-Identifier: MIT
#include "trunk_and_legs.hpp"

#include <vector>

#include "core/index.hpp"
#include "math/axes.hpp"

namespace shigusa {

using Bone = HumanoidBone;

Vec3d TrunkAndLegs::common_axis() const {
  constexpr double kAlong = 0.8;
  const Vec3d axis = nearest_axis(legs);
  const bool both = dot(axis, normalized(legs)) > kAlong && dot(axis, normalized(trunk)) > kAlong;
  return both ? axis : Vec3d{};
}

Vec3d TrunkAndLegs::common_line() const {
  constexpr double kStraight = 0.98;  // cosine of 11°
  const Vec3d up = normalized(normalized(trunk) + normalized(legs));
  return dot(normalized(trunk), normalized(legs)) > kStraight ? up : Vec3d{};
}

TrunkAndLegs TrunkAndLegs::at_rest(const Skeleton& skeleton, const HumanoidMap& map) {
  const std::vector<Vec3d> rest = rest_origins(skeleton);
  const auto mid = [&](Bone a, Bone b) {
    return (rest[index(map[a])] + rest[index(map[b])]) * 0.5;
  };
  const Vec3d hips = mid(Bone::left_upper_leg, Bone::right_upper_leg);
  return {mid(Bone::left_upper_arm, Bone::right_upper_arm) - hips,
          hips - mid(Bone::left_foot, Bone::right_foot)};
}

}  // namespace shigusa
