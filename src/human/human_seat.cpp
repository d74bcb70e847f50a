// SPDX-License-Identifier: MIT
#include "human/at_ease.hpp"
#include "human_builder.hpp"

namespace shigusa {
namespace {

// The part of a thigh that lies on the seat: from behind the hip joint (share of the stature) to a
// share of the way to the knee, and half as broad as this (share of the stature).
constexpr double kBehindHip = 0.06;
constexpr double kToKnee = 0.7;
constexpr double kHalfBreadth = 0.045;
// Soles that are higher than this (m) bear nothing.
constexpr double kOnTheFloor = 0.02;

// a seated person's hip bends as far as with a bent knee
JointLimits with_bent_knee(JointLimits hip, double gain) {
  hip.upper += gain;
  return hip;
}

}  // namespace

// A seated person's leg, all one piece. The first of them carries the trunk, which hangs on no
// joint yet, as a standing leg does.
void HumanBuilder::add_seated_leg(Side side) {
  const Landmarks::Leg& leg = person_.leg(side);
  const Mat3d& frame = frames_.leg(side).thigh;
  const JointLimits bends = whole() ? with_bent_knee(kFreeHipFlexion, kFreeHipFlexionGain)
                                    : with_bent_knee(kHipFlexion, kHipFlexionGain);
  LinkMass mass = masses_.thigh(side);
  mass.add(masses_.shank(side));
  mass.add(masses_.foot(side));
  Part thigh{kBaseLink, frame, leg.hip};
  if (side == base_side_) {
    body_.base = {frame, leg.hip};
    body_.base_mass = mass.in_frame(frame, leg.hip);
    trunk_ = {add_hip_above(side, thigh, bends)};
  } else {
    thigh = add_hip_below(side, bends);
    set_mass(thigh, mass);
  }
  LegParts& parts = legs_[index_of(side)];
  parts.thigh = parts.shank = parts.foot = parts.toes = thigh;
  add_leg_capsules(side);
  add_seat(side, thigh);
}

void HumanBuilder::add_seat(Side side, const Part& thigh) {
  const Landmarks::Leg& leg = person_.leg(side);
  const double h = settings_.stature;
  const Vec3d to_knee = leg.knee - leg.hip;
  const Vec3d ahead = normalized(Vec3d{to_knee.x, 0.0, to_knee.z}, {0, 0, 1});
  const Vec3d across = Vec3d{ahead.z, 0.0, -ahead.x} * (kHalfBreadth * h);
  const Vec3d down{0.0, -kSeatedHip * h, 0.0};
  const Vec3d behind = leg.hip + down - ahead * (kBehindHip * h);
  const Vec3d front = leg.hip + down + ahead * (kToKnee * dot(to_knee, ahead));
  std::vector<Vec3d> corners{front + across, behind + across, behind - across, front - across};
  Foot seat;
  seat.name = prefix_of(side) + "upper_leg";
  seat.link = thigh.link;
  seat.node = seat.name;
  for (const Vec3d& corner : corners) seat.centre += in_link(corner, thigh) * 0.25;
  const SoleOutline sole = sole_outline(leg, h);
  if (sole[0].y < kOnTheFloor) corners.insert(corners.end(), sole.begin(), sole.end());
  for (const Vec3d& corner : corners) seat.outline.push_back(in_link(corner, thigh));
  body_.feet.push_back(std::move(seat));
}

}  // namespace shigusa
