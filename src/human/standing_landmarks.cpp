// SPDX-License-Identifier: MIT
#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "landmark_points.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

// Angles at ease: with 4.5° forward lean of the shank and 0.5° backward lean of the thigh the knee
// is bent by 5°, and the centre of mass is a few centimetres ahead of the ankles, as people's is.
constexpr double kShankLean = radians(4.5);
constexpr double kThighLean = radians(-0.5);
constexpr double kElbowBend = radians(10.0);

// Vector of a segment: upwards, leaning by `lean` in the vertical plane at angle `yaw` about +Y
// from the sagittal one.
Vec3d leaning(double length, double lean, double yaw) {
  const SinCos<double> l = sin_cos(lean);
  const SinCos<double> t = sin_cos(yaw);
  return Vec3d{l.sin * t.sin, l.cos, l.sin * t.cos} * length;
}

// Landmarks of one leg. `side`: +1 left, -1 right.
Landmarks::Leg standing_leg(double h, double toe_out, double side) {
  Landmarks::Leg leg;
  const double yaw = side * toe_out;
  const Vec3d shank = leaning(F::kShank * h, kShankLean, yaw);
  const Vec3d thigh = leaning(F::kThigh * h, kThighLean, yaw);
  leg.hip = {side * F::kHipHalfBreadth * h, F::kAnkleHeight * h + shank.y + thigh.y,
             shank.z + thigh.z};
  leg.knee = leg.hip - thigh;
  leg.ankle = leg.knee - shank;
  const SinCos<double> t = sin_cos(yaw);
  const double ahead = (1.0 - kHeelShare) * F::kFootLength * h;
  leg.toe = {leg.ankle.x + t.sin * ahead, 0.0, leg.ankle.z + t.cos * ahead};
  return leg;
}

Landmarks::Arm hanging_arm(double h, const Vec3d& mid_hip, double side) {
  Landmarks::Arm arm;
  const double trunk = (F::kShoulderHeight - F::kAnkleHeight - F::kShank - F::kThigh) * h;
  arm.shoulder = mid_hip + Vec3d{side * F::kShoulderHalfBreadth * h, trunk, 0.0};
  arm.elbow = arm.shoulder - Vec3d{0.0, F::kUpperArm * h, 0.0};
  const Vec3d along{0.0, -sin_cos(kElbowBend).cos, sin_cos(kElbowBend).sin};
  arm.wrist = arm.elbow + along * (F::kForearm * h);
  arm.fingertip = arm.wrist + along * (F::kHand * h);
  arm.clavicle =
      mid_hip + Vec3d{side * F::kClavicleHalfBreadth * h, trunk + F::kClavicleRise * h, 0.0};
  return arm;
}

}  // namespace

Landmarks standing_landmarks(double stature, double toe_out) {
  const double h = stature;
  Landmarks person;
  person.left_leg = standing_leg(h, toe_out, 1.0);
  person.right_leg = standing_leg(h, toe_out, -1.0);
  const Vec3d hips = mid_hip(person);
  person.left_arm = hanging_arm(h, hips, 1.0);
  person.right_arm = hanging_arm(h, hips, -1.0);
  const double drop = F::kAnkleHeight * h + (F::kShank + F::kThigh) * h - hips.y;
  person.head_top = {0.0, h - drop, hips.z};
  person.neck = {0.0, (1.0 - F::kHeadLength) * h - drop, hips.z};
  for (const double share : kSpineShares) {
    person.spine.push_back(hips + (person.neck - hips) * share);
  }
  person.head = person.neck + (person.head_top - person.neck) * kHeadJointShare;
  return person;
}

Vec3d toes_joint(const Landmarks::Leg& leg) {
  return leg.toes ? *leg.toes : leg.ankle + (leg.toe - leg.ankle) * kToesShare;
}

Vec3d grip_of(const Landmarks::Arm& arm) {
  return arm.grip.value_or(arm.wrist + (arm.fingertip - arm.wrist) * kGripFraction);
}

}  // namespace shigusa
