// SPDX-License-Identifier: MIT
#include "rig_twist.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "math/turn_about.hpp"
#include "rig_drivers.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

bool is_left(Bone bone) { return humanoid_bone_name(bone).starts_with("left_"); }
bool is_arm(Bone bone) { return humanoid_bone_name(bone).ends_with("_arm"); }

// The joints at both ends of a segment.
std::array<Vec3d, 2> ends_of(const TwistSegment& segment, const Landmarks& person) {
  const Side side = is_left(segment.bone) ? Side::left : Side::right;
  const Landmarks::Arm& arm = person.arm(side);
  const Landmarks::Leg& leg = person.leg(side);
  if (is_arm(segment.bone)) {
    return segment.lower ? std::array{arm.elbow, arm.wrist} : std::array{arm.shoulder, arm.elbow};
  }
  return segment.lower ? std::array{leg.knee, leg.ankle} : std::array{leg.hip, leg.knee};
}

// The bones that may carry an upper limb, the nearest first.
std::vector<Bone> bones_above(Bone bone) {
  if (!is_arm(bone)) return {Bone::hips};
  return {is_left(bone) ? Bone::left_shoulder : Bone::right_shoulder, Bone::upper_chest,
          Bone::chest, Bone::spine, Bone::hips};
}

// Angle of the twist T in a rotation S T about a unit axis.
double twist_of(const Mat3d& rotation, const Vec3d& axis) {
  const Quatd q = to_quat(rotation);
  return 2.0 * atan2(q.x * axis.x + q.y * axis.y + q.z * axis.z, q.w);
}

// The same angle modulo whole turns, nearest to `before`.
double near_to(double before, double angle) {
  while (angle - before > kPi) angle -= kTwoPi;
  while (angle - before < -kPi) angle += kTwoPi;
  return angle;
}

}  // namespace

std::optional<ForearmTurn> forearm_turn(const BodyModel& body, HumanoidBone bone) {
  if (bone != Bone::left_lower_arm && bone != Bone::right_lower_arm) return std::nullopt;
  const auto dof = body.find_dof(JointKind::elbow, FreedomKind::rotation,
                                 bone == Bone::left_lower_arm ? Side::left : Side::right);
  if (!dof) return std::nullopt;
  return ForearmTurn{*dof};
}

double ForearmTurn::angle(const Kinematics<double>& placed) const {
  const SinCos<double>& turn = placed.turn[static_cast<std::size_t>(dof)];
  return atan2(turn.sin, turn.cos);
}

LimbTwists::LimbTwists(const BodyModel& body, const Rig& rig, const HumanFrames& rest,
                       const HumanFrames& start, const Kinematics<double>& standing) {
  for (const TwistSegment& segment : twist_segments()) {
    const bool any = std::any_of(rig.twists.begin(), rig.twists.end(),
                                 [&](const TwistBone& t) { return t.bone == segment.bone; });
    const auto driver = bone_driver(segment.bone, body, rig, rest, start);
    const auto next = bone_driver(segment.next, body, rig, rest, start);
    // a half body's left leg has no turn of its own
    if (!any || !driver || !next || !driver->carries) continue;
    const auto [joint, end] = ends_of(segment, rig.start);
    const Transformd placed{standing.link_rotation(driver->link),
                            standing.link_origin(driver->link)};
    Limb limb{.segment = segment, .link = driver->link, .beyond = next->link};
    limb.joint = inverse(placed) * joint;
    limb.axis = normalized(transpose_times(placed.rotation, joint - end), {0, 1, 0});
    if (segment.lower) {
      limb.start = transpose(placed.rotation) * standing.link_rotation(limb.beyond);
      limb.forearm = forearm_turn(body, segment.bone);
    } else {
      const double aside = !is_arm(segment.bone) ? 0.0 : is_left(segment.bone) ? 0.5 : -0.5;
      limb.reference = rotation(Axis::z, aside * kPi);
      for (const Bone above : bones_above(segment.bone)) {
        const auto bears = bone_driver(above, body, rig, rest, start);
        if (!bears) continue;
        limb.above = bears->link;
        const Mat3d was = transpose(bears->to_start.rotation) * standing.link_rotation(bears->link);
        const Mat3d limb_was = transpose(driver->to_start.rotation) * placed.rotation;
        limb.rest = twist_of(transpose(was * limb.reference) * limb_was, limb.axis);
        break;
      }
    }
    limbs_.push_back(limb);
  }
}

void LimbTwists::show(const Kinematics<double>& now) {
  for (Limb& limb : limbs_) {
    limb.placed = {now.link_rotation(limb.link), now.link_origin(limb.link)};
    const Mat3d& turned = limb.placed.rotation;
    if (limb.segment.lower) {
      limb.at_joint = limb.forearm ? limb.forearm->angle(now) : 0.0;
      const Mat3d end = transpose(turned) * now.link_rotation(limb.beyond);
      limb.at_end = near_to(limb.at_end, twist_of(end * transpose(limb.start), limb.axis));
    } else {
      const Mat3d from = now.link_rotation(limb.above) * limb.reference;
      limb.at_joint =
          near_to(limb.at_joint, twist_of(transpose(from) * turned, limb.axis) - limb.rest);
    }
  }
}

int LimbTwists::find(HumanoidBone bone) const {
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    if (limbs_[i].segment.bone == bone) return static_cast<int>(i);
  }
  return -1;
}

Transformd LimbTwists::turn(int limb, double share) const {
  const Limb& l = limbs_[static_cast<std::size_t>(limb)];
  const double angle =
      l.segment.lower ? share * (l.at_joint + l.at_end) - l.at_joint : (share - 1.0) * l.at_joint;
  const Mat3d turn = turn_about(l.placed.rotation * l.axis, angle);
  const Vec3d joint = l.placed * l.joint;
  return {turn, joint - turn * joint};
}

}  // namespace shigusa
