// SPDX-License-Identifier: MIT
#include "human_builder.hpp"
#include "person/at_ease.hpp"

namespace shigusa {
namespace {

// What of a thigh lies on the seat: from behind the hip joint (share of the stature) to a share of
// the way to the knee, and half as broad as this (share of the stature).
constexpr double kBehindHip = 0.06;
constexpr double kToKnee = 0.7;
constexpr double kHalfBreadth = 0.045;
// Soles that are higher than this (m) bear nothing.
constexpr double kOnTheFloor = 0.02;

// the hip of who sits bends as far as with a bent knee
JointLimits with_bent_knee(JointLimits hip, double gain) {
  hip.upper += gain;
  return hip;
}

}  // namespace

// A leg of who sits, all one piece. The first of them carries the trunk, which hangs on no joint
// yet, as a standing leg does.
void HumanBuilder::add_seated_leg(Side side) {
  const double s = side_sign(side);
  const std::string prefix = prefix_of(side);
  const Landmarks::Leg& leg = person_.leg(side);
  const Mat3d& frame = frames_.leg(side).thigh;
  const BallAngles angles = ball_angles(transpose(frames_.trunk) * frame, side);
  const JointLimits bends = whole() ? with_bent_knee(kFreeHipFlexion, kFreeHipFlexionGain)
                                    : with_bent_knee(kHipFlexion, kHipFlexionGain);
  LinkMass mass = masses_.thigh(side);
  mass.add(masses_.shank(side));
  mass.add(masses_.foot(side));
  Part thigh{kBaseLink, frame, leg.hip};
  if (side == base_side_) {
    body_.base = {frame, leg.hip};
    body_.base_mass = mass.in_frame(frame, leg.hip);
    trunk_ = {add_joint(prefix + "hip", thigh, leg.hip, frames_.trunk,
                        {{"rotation", Axis::y, -s, kHipRotation, angles.rotation},
                         {"abduction", Axis::z, -s, kHipAbduction, angles.abduction},
                         {"flexion", Axis::x, 1.0, bends, angles.flexion}})};
  } else {
    thigh = add_joint(prefix + "hip", trunk_.front(), leg.hip, frame,
                      {{"flexion", Axis::x, -1.0, bends, angles.flexion},
                       {"abduction", Axis::z, s, kHipAbduction, angles.abduction},
                       {"rotation", Axis::y, s, kHipRotation, angles.rotation}});
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
  const Vec3d way = leg.knee - leg.hip;
  const Vec3d ahead = normalized(Vec3d{way.x, 0.0, way.z}, {0, 0, 1});
  const Vec3d across = Vec3d{ahead.z, 0.0, -ahead.x} * (kHalfBreadth * h);
  const Vec3d down{0.0, -kSeatedHip * h, 0.0};
  const Vec3d behind = leg.hip + down - ahead * (kBehindHip * h);
  const Vec3d front = leg.hip + down + ahead * (kToKnee * dot(way, ahead));
  std::vector<Vec3d> corners{front + across, behind + across, behind - across, front - across};
  Foot seat;
  seat.name = prefix_of(side) + "upper_leg";
  seat.link = thigh.link;
  seat.node = seat.name;
  const auto local = [&thigh](const Vec3d& p) {
    return transpose_times(thigh.frame, p - thigh.origin);
  };
  for (const Vec3d& corner : corners) seat.centre += local(corner) * 0.25;
  const SoleOutline sole = sole_outline(leg, h);
  if (sole[0].y < kOnTheFloor) corners.insert(corners.end(), sole.begin(), sole.end());
  for (const Vec3d& corner : corners) seat.outline.push_back(local(corner));
  body_.feet.push_back(std::move(seat));
}

}  // namespace shigusa
