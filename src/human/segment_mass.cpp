// SPDX-License-Identifier: MIT
#include "segment_mass.hpp"

#include "landmark_points.hpp"

namespace shigusa {

SoleOutline sole_outline(const Landmarks::Leg& leg, double stature) {
  if (leg.sole) return *leg.sole;
  using F = StatureFractions;
  Vec3d ahead = leg.toe - leg.ankle;
  ahead.y = 0.0;
  ahead = normalized(ahead, {0, 0, 1});
  const Vec3d left{ahead.z, 0.0, -ahead.x};
  const double height = leg.ankle.y - F::kAnkleHeight * stature;
  const Vec3d toe{leg.toe.x, height, leg.toe.z};
  const Vec3d heel{leg.ankle.x - ahead.x * kHeelShare * F::kFootLength * stature, height,
                   leg.ankle.z - ahead.z * kHeelShare * F::kFootLength * stature};
  const Vec3d half = left * (0.5 * F::kFootBreadth * stature);
  return {toe + half, heel + half, heel - half, toe - half};
}

double stature_of_limbs(const Landmarks& person, double stature) {
  constexpr double kUsual = StatureFractions::kHeadLength;
  const double head = norm(person.head_top - person.neck);
  return head > kBigHead * kUsual * stature ? (stature - head) / (1.0 - kUsual) : stature;
}

SoleOutline forefoot_outline(const Landmarks::Leg& leg, double stature) {
  SoleOutline sole = sole_outline(leg, stature);
  const Vec3d back = sole[1] - sole[0];
  const Vec3d tip = (sole[0] + sole[3]) * 0.5;
  // the joint of a file may lie anywhere: both parts of the foot keep some length
  const double share = clamp(dot(toes_joint(leg) - tip, back) / dot(back, back), 0.05, 0.95);
  sole[1] = sole[0] + back * share;
  sole[2] = sole[3] + back * share;
  return sole;
}

LinkMass SegmentMasses::segment(const SegmentParameters& p, const Vec3d& from, const Vec3d& to,
                                const Vec3d& left) const {
  const double length = norm(to - from);
  const Vec3d axis = normalized(to - from);
  const Vec3d ahead = normalized(cross(left, axis), {0, 0, 1});
  const Vec3d across = cross(axis, ahead);
  const double mass = p.mass * mass_;
  const auto about = [&](const Vec3d& a, double r) {
    return scaled(outer(a, a), mass * (r * length) * (r * length));
  };
  const Mat3d inertia =
      about(ahead, p.r_sagittal) + about(across, p.r_transverse) + about(axis, p.r_long);
  const Vec3d com = from + (to - from) * p.com;
  return LinkMass::of(mass, com, inertia);
}

LinkMass SegmentMasses::foot(Side side) const {
  const SoleOutline sole = sole_outline(person_.leg(side), stature_);
  const Vec3d toe = (sole[0] + sole[3]) * 0.5;
  const Vec3d heel = (sole[1] + sole[2]) * 0.5;
  // the segment's axis is at half the ankle's height, inside the foot
  const Vec3d rise{0.0, 0.5 * StatureFractions::kAnkleHeight * stature_, 0.0};
  return segment(table_.foot, heel + rise, toe + rise, frames_.leg(side).foot.cx);
}

// Mass of the forefoot, as a round rod as thick as the foot.
LinkMass SegmentMasses::forefoot(Side side) const {
  const Landmarks::Leg& leg = person_.leg(side);
  const SoleOutline sole = sole_outline(leg, stature_);
  const SoleOutline toes = forefoot_outline(leg, stature_);
  const Vec3d tip = (toes[0] + toes[3]) * 0.5;
  const Vec3d joint = (toes[1] + toes[2]) * 0.5;
  const double share = norm(tip - joint) / norm(sole[0] - sole[1]);
  const double thick = table_.foot.r_long / share;
  const double across = sqrt(1.0 / 12.0 + 0.5 * thick * thick);
  const SegmentParameters part{.mass = table_.foot.mass * kToesMass,
                               .com = 0.5,
                               .r_sagittal = across,
                               .r_transverse = across,
                               .r_long = thick};
  const Vec3d rise{0.0, 0.5 * StatureFractions::kAnkleHeight * stature_, 0.0};
  return segment(part, joint + rise, tip + rise, frames_.leg(side).foot.cx);
}

LinkMass SegmentMasses::shank(Side side) const {
  const Landmarks::Leg& leg = person_.leg(side);
  return segment(table_.shank, leg.knee, leg.ankle, frames_.leg(side).shank.cx);
}

LinkMass SegmentMasses::thigh(Side side) const {
  const Landmarks::Leg& leg = person_.leg(side);
  return segment(table_.thigh, leg.hip, leg.knee, frames_.leg(side).thigh.cx);
}

LinkMass SegmentMasses::trunk_and_head() const {
  LinkMass result =
      segment(table_.trunk, mid_shoulder(person_), mid_hip(person_), frames_.trunk.cx);
  result.add(head());
  return result;
}

LinkMass SegmentMasses::head() const {
  return segment(table_.head, person_.head_top, person_.neck, frames_.trunk.cx);
}

// Mass of a slice. A shortened part of uniform density keeps the spread of its cross section: its
// radii of gyration less a rod's, length / √12.
LinkMass SegmentMasses::trunk_slice(double from, double to) const {
  const Vec3d hips = mid_hip(person_);
  const Vec3d trunk = person_.neck - hips;
  constexpr double kRod = 1.0 / 12.0;
  const auto across = [](double r) { return r * r - kRod; };
  LinkMass result;
  double begin = 0.0;
  for (const TrunkPart& part : table_.trunk_parts) {
    const double low = max(from, begin);
    const double high = min(to, begin + part.length);
    begin += part.length;
    if (!(high > low)) continue;
    const double share = (high - low) / part.length;
    const double rod = kRod * share * share;
    const auto radius = [&](double r) { return sqrt(across(r) + rod) / share; };
    const SegmentParameters slice{.mass = part.mass * share,
                                  .com = 0.5,
                                  .r_sagittal = radius(part.r_sagittal),
                                  .r_transverse = radius(part.r_transverse),
                                  .r_long = part.r_long / share};
    result.add(segment(slice, hips + trunk * low, hips + trunk * high, frames_.trunk.cx));
  }
  return result;
}

LinkMass SegmentMasses::upper_arm(Side side) const {
  const Landmarks::Arm& arm = person_.arm(side);
  return segment(table_.upper_arm, arm.shoulder, arm.elbow, frames_.arm(side).upper_arm.cx);
}

LinkMass SegmentMasses::forearm(Side side) const {
  const Landmarks::Arm& arm = person_.arm(side);
  return segment(table_.forearm, arm.elbow, arm.wrist, frames_.arm(side).forearm.cx);
}

LinkMass SegmentMasses::hand(Side side) const {
  const Landmarks::Arm& arm = person_.arm(side);
  return segment(table_.hand, arm.wrist, arm.fingertip, frames_.arm(side).forearm.cx);
}

LinkMass SegmentMasses::forearm_and_hand(Side side) const {
  LinkMass result = forearm(side);
  result.add(hand(side));
  return result;
}

LinkMass SegmentMasses::arm(Side side) const {
  LinkMass result = upper_arm(side);
  result.add(forearm_and_hand(side));
  return result;
}

}  // namespace shigusa
