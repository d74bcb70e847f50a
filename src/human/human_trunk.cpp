// SPDX-License-Identifier: MIT
#include <array>
#include <tuple>

#include "human_builder.hpp"

namespace shigusa {
namespace {

constexpr std::array kSpineNames{"spine", "chest", "upper_chest"};
// Position of the chest's node in a rigid trunk, as a share of the line from hips to shoulders.
constexpr double kRigidChest = 0.6;

JointLimits part_of_range(const JointLimits& all, double share) {
  return {all.lower * share, all.upper * share, all.torque_positive, all.torque_negative};
}

}  // namespace

// Adds the trunk to the existing pelvis.
void HumanBuilder::add_trunk() {
  if (whole()) {
    add_spine();
    add_neck();
  } else {
    neck_ = head_ = trunk_.front();
    LinkMass trunk = masses_.trunk_and_head();
    if (settings_.extent == BodyExtent::half) trunk.add(masses_.arm(Side::left));
    set_mass(trunk_.front(), trunk);
  }
  add_trunk_capsules();
}

// Adds the spine's joints.
void HumanBuilder::add_spine() {
  const std::size_t joints = std::min(person_.spine.size(), kSpineJoints);
  const Vec3d trunk = person_.neck - mid_hip(person_);
  double begin = 0.0;
  for (std::size_t j = 0; j < joints; ++j) {
    const SpineShares range = spine_shares(j, joints);
    Part part =
        add_joint(kSpineNames[j], trunk_.back(), person_.spine[j], frames_.trunk,
                  {{"flexion", Axis::x, 1.0, part_of_range(kSpineFlexion, range.flexion)},
                   {"lateral", Axis::z, -1.0, part_of_range(kSpineLateral, range.lateral)},
                   {"rotation", Axis::y, 1.0, part_of_range(kSpineRotation, range.rotation)}});
    part.from =
        clamp(dot(person_.spine[j] - mid_hip(person_), trunk) / dot(trunk, trunk), begin, 1.0);
    set_mass(trunk_.back(), masses_.trunk_slice(begin, part.from));
    begin = part.from;
    trunk_.push_back(part);
  }
  set_mass(trunk_.back(), masses_.trunk_slice(begin, 1.0));
}

void HumanBuilder::add_neck() {
  const auto joint = [&](const char* name, const Part& on, const Vec3d& at) {
    return add_joint(name, on, at, frames_.trunk,
                     {{"flexion", Axis::x, 1.0, kNeckFlexion},
                      {"lateral", Axis::z, -1.0, kNeckLateral},
                      {"rotation", Axis::y, 1.0, kNeckRotation}});
  };
  neck_ = joint("neck", trunk_.back(), person_.neck);
  head_ = person_.head ? joint("head", neck_, *person_.head) : neck_;
  set_mass(head_, masses_.head());
}

// Part that carries the arm: its clavicle, or else the trunk.
HumanBuilder::Part HumanBuilder::add_clavicle(Side side) {
  const Landmarks::Arm& arm = person_.arm(side);
  if (!whole() || !arm.clavicle) return trunk_.back();
  const double s = side_sign(side);
  return add_joint(side_prefix(side) + "clavicle", trunk_.back(), *arm.clavicle, frames_.trunk,
                   {{"elevation", Axis::z, s, kClavicleElevation},
                    {"protraction", Axis::y, -s, kClavicleProtraction}});
}

int HumanBuilder::add_node(const std::string& name, int parent, const Part& part,
                           const Vec3d& point, bool end_site) {
  body_.nodes.push_back({name, parent, part.link, in_link(point, part), end_site});
  return static_cast<int>(body_.nodes.size()) - 1;
}

void HumanBuilder::add_nodes() {
  const int hips = add_node("hips", -1, trunk_.front(), mid_hip(person_));
  const int chest = add_trunk_nodes(hips);
  for (const Side side : kBothSides) {
    if (side == Side::left && settings_.extent == BodyExtent::half) {
      add_stubs(hips, chest);
      continue;
    }
    add_arm_nodes(side, chest);
    add_leg_nodes(side, hips);
  }
}

// Adds the trunk's nodes; returns the one that carries arms and neck.
int HumanBuilder::add_trunk_nodes(int hips) {
  int chest = hips;
  for (std::size_t j = 1; j < trunk_.size(); ++j) {
    chest = add_node(kSpineNames[j - 1], chest, trunk_[j], trunk_[j].origin);
  }
  if (trunk_.size() == 1) {
    const Vec3d at = mid_hip(person_) + (mid_shoulder(person_) - mid_hip(person_)) * kRigidChest;
    chest = add_node("chest", hips, trunk_.front(), at);
  }
  const Vec3d fixed = person_.neck + (person_.head_top - person_.neck) * kHeadJointShare;
  const int neck = add_node("neck", chest, neck_, person_.neck);
  const int head = add_node("head", neck, head_, whole() ? head_joint(person_) : fixed);
  add_node("", head, head_, person_.head_top, true);
  return chest;
}

// Adds stubs of the fixed limbs, which are not shown (paper, section 4), on the trunk, which is.
void HumanBuilder::add_stubs(int hips, int chest) {
  const Vec3d stub = (mid_hip(person_) - mid_shoulder(person_)) * 0.05;
  for (const auto& [name, parent, at] :
       {std::tuple{"left_upper_arm", chest, person_.left_arm.shoulder},
        std::tuple{"left_upper_leg", hips, person_.left_leg.hip}}) {
    add_node("", add_node(name, parent, trunk_.front(), at), trunk_.front(), at + stub, true);
  }
}

void HumanBuilder::add_arm_nodes(Side side, int chest) {
  const std::string prefix = side_prefix(side);
  const Landmarks::Arm& arm = person_.arm(side);
  const ArmParts& parts = arms_[index_of(side)];
  int on = chest;
  if (whole() && arm.clavicle) {
    on = add_node(prefix + "shoulder", on, parts.clavicle, *arm.clavicle);
  }
  on = add_node(prefix + "upper_arm", on, parts.upper, arm.shoulder);
  on = add_node(prefix + "lower_arm", on, parts.fore, arm.elbow);
  on = add_node(prefix + "hand", on, parts.hand, arm.wrist);
  on = add_node(prefix + "hand_grip", on, parts.hand, grip_of(arm));
  add_node("", on, parts.hand, arm.fingertip, true);
}

void HumanBuilder::add_leg_nodes(Side side, int hips) {
  const std::string prefix = side_prefix(side);
  const Landmarks::Leg& leg = person_.leg(side);
  const LegParts& parts = legs_[index_of(side)];
  int on = add_node(prefix + "upper_leg", hips, parts.thigh, leg.hip);
  on = add_node(prefix + "lower_leg", on, parts.shank, leg.knee);
  on = add_node(prefix + "foot", on, parts.foot, leg.ankle);
  on = add_node(prefix + "toes", on, parts.toes, toes_joint(leg));
  add_node("", on, parts.toes, leg.toe, true);
}

}  // namespace shigusa
