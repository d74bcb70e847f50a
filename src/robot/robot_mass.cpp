// SPDX-License-Identifier: MIT
// Masses of a robot whose file has none: a person's, distributed over its limbs.
#include <algorithm>

#include "body/anthropometry.hpp"
#include "body/link_mass.hpp"
#include "core/index.hpp"
#include "robot_builder.hpp"

namespace shigusa {
namespace {

// Adds a segment's mass to a link: a rod with those radii of gyration, in the link's frame.
void add_segment(Robot::Link& link, const Transformd& place, const SegmentParameters& part,
                 double mass, const Vec3d& from, const Vec3d& to) {
  const double length = norm(to - from);
  const Vec3d along = normalized(to - from);
  const double across = 0.5 * (part.r_sagittal + part.r_transverse) * length;
  const double about = part.r_long * length;
  const Mat3d rod = scaled(outer(along, along), mass * (about * about - across * across)) +
                    scaled(Mat3d{}, mass * across * across);
  LinkMass sum = LinkMass::of(mass, from + (to - from) * part.com, rod);
  if (link.mass > 0.0) {
    sum.add(LinkMass::of(link.mass, place * link.com,
                         place.rotation * link.inertia * transpose(place.rotation)));
  }
  const MassProperties own = sum.in_frame(Mat3d{}, {});
  link.mass = own.mass;
  link.com = transpose_times(place.rotation, own.com - place.translation);
  link.inertia = transpose(place.rotation) * own.inertia * place.rotation;
}

}  // namespace

void RobotBuilder::spread_mass(double mass) {
  const SegmentTable& table = segment_table(Sex::male);
  const auto add = [&](int group, const SegmentParameters& part, double share, const Vec3d& from,
                       const Vec3d& to) {
    const int link = members_[index(group)][0];
    add_segment(robot_.links[index(link)], placed_.links[index(link)], part, share * mass, from,
                to);
  };
  const Vec3d hips = (hip(0) + hip(1)) * 0.5;
  const Vec3d shoulders = (shoulder(0) + shoulder(1)) * 0.5;
  // the lowest part of the trunk moves with the pelvis
  const double pelvis = table.trunk_parts[0].mass;
  add(group_[index(person_.pelvis)], table.trunk, pelvis, hips + (shoulders - hips) * 0.3, hips);
  add(group_[index(person_.chest)], table.trunk, table.trunk.mass - pelvis, shoulders,
      hips + (shoulders - hips) * 0.2);
  const int head = person_.neck.empty()
                       ? group_[index(person_.chest)]
                       : moving_[index(of_joint_[index(person_.neck.back().joint)])].outer;
  const Vec3d top =
      shoulders + Vec3d{0.0, (1.0 - StatureFractions::kShoulderHeight) * body_.stature, 0.0};
  add(head, table.head, table.head.mass, top, shoulders);
  for (const std::size_t side : {0u, 1u}) {
    const PersonLimb& leg = person_.legs[side];
    const PersonLimb& arm = person_.arms[side];
    const RobotSole& sole = soles_[side];
    const Vec3d toe = (sole.corners[0] + sole.corners[3]) * 0.5;
    const Vec3d heel = (sole.corners[1] + sole.corners[2]) * 0.5;
    const Vec3d tip = wrist(side) + normalized(wrist(side) - elbow(side), {0, -1, 0}) *
                                        (StatureFractions::kHand * body_.stature);
    add(group_before(leg, 1), table.thigh, table.thigh.mass, hip(side), knee(side));
    add(group_before(leg, 2), table.shank, table.shank.mass, knee(side), ankle(side));
    add(group_[index(leg.end)], table.foot, table.foot.mass, heel, toe);
    add(group_before(arm, 2), table.upper_arm, table.upper_arm.mass, shoulder(side), elbow(side));
    add(group_before(arm, 3), table.forearm, table.forearm.mass, elbow(side), wrist(side));
    add(group_[index(arm.end)], table.hand, table.hand.mass, wrist(side), tip);
  }
}

}  // namespace shigusa
