// SPDX-License-Identifier: MIT
#include <shigusa/landmarks.hpp>

#include "body/anthropometry.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

// At ease: the shank leans forward by 4.5°, the thigh back by 0.5°, so the knee is bent by 5° and
// the centre of mass stands a few centimetres ahead of the ankles, as people's does.
constexpr double kShankLean = radians(4.5);
constexpr double kThighLean = radians(-0.5);
constexpr double kElbowBend = radians(10.0);

// A segment's vector: upwards, leaning by `lean` in the vertical plane that is turned by `yaw`
// about +Y from the sagittal one.
Vec3d leaning(double length, double lean, double yaw) {
  const SinCos<double> l = sin_cos(lean);
  const SinCos<double> t = sin_cos(yaw);
  return Vec3d{l.sin * t.sin, l.cos, l.sin * t.cos} * length;
}

}  // namespace

Landmarks standing_landmarks(double stature, double toe_out) {
  const double h = stature;
  Landmarks person;
  const auto leg = [&](double side) {  // +1 left, -1 right
    Landmarks::Leg result;
    const double yaw = side * toe_out;
    const Vec3d shank = leaning(F::kShank * h, kShankLean, yaw);
    const Vec3d thigh = leaning(F::kThigh * h, kThighLean, yaw);
    result.hip = {side * F::kHipHalfBreadth * h, F::kAnkleHeight * h + shank.y + thigh.y,
                  shank.z + thigh.z};
    result.knee = result.hip - thigh;
    result.ankle = result.knee - shank;
    const SinCos<double> t = sin_cos(yaw);
    const double ahead = (1.0 - kHeelShare) * F::kFootLength * h;
    result.toe = {result.ankle.x + t.sin * ahead, 0.0, result.ankle.z + t.cos * ahead};
    return result;
  };
  person.left_leg = leg(1.0);
  person.right_leg = leg(-1.0);
  const Vec3d mid_hip = (person.left_leg.hip + person.right_leg.hip) * 0.5;
  const double trunk = (F::kShoulderHeight - F::kAnkleHeight - F::kShank - F::kThigh) * h;
  const auto arm = [&](double side) {
    Landmarks::Arm result;
    result.shoulder = mid_hip + Vec3d{side * F::kShoulderHalfBreadth * h, trunk, 0.0};
    result.elbow = result.shoulder - Vec3d{0.0, F::kUpperArm * h, 0.0};
    const Vec3d along{0.0, -sin_cos(kElbowBend).cos, sin_cos(kElbowBend).sin};
    result.wrist = result.elbow + along * (F::kForearm * h);
    result.fingertip = result.wrist + along * (F::kHand * h);
    result.clavicle =
        mid_hip + Vec3d{side * F::kClavicleHalfBreadth * h, trunk + F::kClavicleRise * h, 0.0};
    return result;
  };
  person.left_arm = arm(1.0);
  person.right_arm = arm(-1.0);
  const double drop = F::kAnkleHeight * h + (F::kShank + F::kThigh) * h - mid_hip.y;
  person.head_top = {0.0, h - drop, mid_hip.z};
  person.neck = {0.0, (1.0 - F::kHeadLength) * h - drop, mid_hip.z};
  for (const double share : kSpineShares) {
    person.spine.push_back(mid_hip + (person.neck - mid_hip) * share);
  }
  person.head = person.neck + (person.head_top - person.neck) * kHeadJointShare;
  return person;
}

}  // namespace shigusa
