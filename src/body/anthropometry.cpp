// SPDX-License-Identifier: MIT
#include <shigusa/body/anthropometry.hpp>

namespace shigusa {
namespace {

constexpr SegmentTable kMale{
    .head = {.0694, .5002, .303, .315, .261},
    .trunk = {.4346, .4310, .384, .358, .197},
    .upper_arm = {.0271, .5772, .285, .269, .158},
    .forearm = {.0162, .4574, .276, .265, .121},
    .hand = {.0061, .3624, .288, .235, .184},
    .thigh = {.1416, .4095, .329, .329, .149},
    .shank = {.0433, .4395, .251, .246, .102},
    .foot = {.0137, .4415, .257, .245, .124},
    .trunk_parts = {{{.1117, 145.7 / 603.3, .615, .551, .587},
                     {.1633, 215.5 / 603.3, .482, .383, .468},
                     {.1596, 242.1 / 603.3, .505, .320, .465}}},
    .mean_stature = 1.741,
    .mean_mass = 73.0,
};

constexpr SegmentTable kFemale{
    .head = {.0668, .4841, .271, .295, .261},
    .trunk = {.4257, .3782, .379, .361, .182},
    .upper_arm = {.0255, .5754, .278, .260, .148},
    .forearm = {.0138, .4559, .261, .257, .094},
    .hand = {.0056, .3427, .244, .208, .154},
    .thigh = {.1478, .3612, .369, .364, .162},
    .shank = {.0481, .4352, .267, .263, .092},
    .foot = {.0129, .4014, .299, .279, .139},
    .trunk_parts = {{{.1247, 181.5 / 614.8, .433, .402, .444},
                     {.1465, 205.3 / 614.8, .433, .354, .415},
                     {.1545, 228.0 / 614.8, .466, .314, .449}}},
    .mean_stature = 1.735,
    .mean_mass = 61.9,
};

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

const SegmentTable& segment_table(Sex sex) { return sex == Sex::male ? kMale : kFemale; }

double default_mass(double stature, Sex sex) {
  const SegmentTable& table = segment_table(sex);
  const double ratio = stature / table.mean_stature;
  return table.mean_mass * ratio * ratio;
}

std::optional<double> stature_percentile(std::string_view name, Sex sex) {
  const bool male = sex == Sex::male;
  if (name == "p5") return male ? 1.647 : 1.528;
  if (name == "p50") return male ? 1.755 : 1.627;
  if (name == "p95") return male ? 1.867 : 1.737;
  return std::nullopt;
}

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
