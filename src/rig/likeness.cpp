// SPDX-License-Identifier: MIT
#include "rig/likeness.hpp"

#include <fmt/format.h>

#include "core/say.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {
namespace {

// Bounds of figures, relative to the length of their legs: a dwarf with a big head has a trunk of
// 1.6 and arms of 1.4, a giant arms of 2. People have a trunk of 0.6 and arms of 0.7.
constexpr double kShortestTrunk = 0.2;
constexpr double kLongestTrunk = 4.0;
constexpr double kShortestArm = 0.2;
constexpr double kLongestArm = 4.0;
// Largest ratio of the two sides' lengths; people have 1.0.
constexpr double kFellows = 2.5;
// Largest breadth of shoulders and of hips, relative to trunk and legs; people have 0.3.
constexpr double kBroadest = 1.0;
// Bounds of four-legged animals, relative to the hind legs: a fox has a trunk of 1.3 and forelegs
// of 1.15.
constexpr double kAnimalsTrunk = 0.8;
constexpr double kAnimalsArm = 0.85;

// Lengths of a limb's two segments.
struct Lengths {
  double upper;
  double lower;

  [[nodiscard]] double sum() const { return upper + lower; }
};
Lengths leg_of(const Landmarks& figure, Side side) {
  return {segment_lengths(figure, side)[0], segment_lengths(figure, side)[1]};
}
Lengths arm_of(const Landmarks& figure, Side side) {
  return {segment_lengths(figure, side)[2], segment_lengths(figure, side)[3]};
}

double unevenness(double a, double b) { return max(a, b) / min(a, b); }

// Reason why a pair of limbs is not human; empty if it may be.
Message odd_limbs(const char* limb, Lengths left, Lengths right) {
  for (const Lengths& each : {left, right}) {
    const double share = unevenness(each.upper, each.lower);
    if (share <= kMostUnevenSegments) continue;
    return say("odd_segments", limb, share, kMostUnevenSegments);
  }
  const double share = unevenness(left.sum(), right.sum());
  if (share <= kFellows) return {};
  return say("odd_limbs", limb, share, kFellows);
}

}  // namespace

bool stands_on_four(const Landmarks& f) {
  constexpr double kAcross = 0.64;  // cosine of 50°
  constexpr double kAlong = 0.7;    // cosine of 45°
  constexpr double kLevel = 0.35;   // of the legs
  const Vec3d hips = mid_hip(f);
  const Vec3d ankles = (f.left_leg.ankle + f.right_leg.ankle) * 0.5;
  const Vec3d shoulders = mid_shoulder(f);
  const Vec3d wrists = (f.left_arm.wrist + f.right_arm.wrist) * 0.5;
  const Vec3d down = normalized(ankles - hips);
  const double legs = norm(ankles - hips);
  return abs(dot(normalized(shoulders - hips), down)) < kAcross &&
         dot(normalized(wrists - shoulders), down) > kAlong &&
         abs(dot(wrists - ankles, down)) < kLevel * legs;
}

Message unlike_a_person(const Landmarks& figure) {
  const double legs = 0.5 * (leg_of(figure, Side::left).sum() + leg_of(figure, Side::right).sum());
  const double arms = 0.5 * (arm_of(figure, Side::left).sum() + arm_of(figure, Side::right).sum());
  const double trunk = norm(mid_shoulder(figure) - mid_hip(figure));
  const double trunk_share = trunk / legs;
  const double arm_share = arms / legs;
  if (stands_on_four(figure) && (trunk_share > kAnimalsTrunk || arm_share > kAnimalsArm)) {
    return say("four_legs", trunk_share, arm_share);
  }
  const double breadth = max(norm(figure.left_arm.shoulder - figure.right_arm.shoulder),
                             norm(figure.left_leg.hip - figure.right_leg.hip)) /
                         (trunk + legs);
  if (breadth > kBroadest) {
    return say("broad", breadth, kBroadest);
  }
  if (trunk_share < kShortestTrunk || trunk_share > kLongestTrunk) {
    return say("odd_trunk", trunk_share, kShortestTrunk, kLongestTrunk);
  }
  if (arm_share < kShortestArm || arm_share > kLongestArm) {
    return say("odd_arms", arm_share, kShortestArm, kLongestArm);
  }
  Message odd_legs = odd_limbs("leg", leg_of(figure, Side::left), leg_of(figure, Side::right));
  if (!odd_legs.empty()) return odd_legs;
  return odd_limbs("arm", arm_of(figure, Side::left), arm_of(figure, Side::right));
}

}  // namespace shigusa
