// SPDX-License-Identifier: MIT
#include "paper/arm_motion.hpp"

#include <utility>

#include "core/check.hpp"
#include "human/segment_mass.hpp"

namespace shigusa {
namespace {

// The mass of the elbow's link with all links beyond it.
MassProperties held_mass(const BodyModel& body, const State& start, int elbow) {
  LinkMass sum = link_mass(body.link_mass(elbow));
  for (int link = elbow + 1; link < body.dof_count(); ++link) {
    if (!body.moves(elbow, link)) continue;
    const Transformd back = inverse(held_place(body, start, elbow, link));
    sum.add(link_mass(link_mass(body.link_mass(link)).in_frame(back.rotation, back.translation)));
  }
  return sum.in_frame(Mat3d{}, {});
}

bool holds_more(const BodyModel& body, int elbow) {
  return elbow + 1 < body.dof_count() && body.moves(elbow, elbow + 1);
}

}  // namespace

std::vector<int> arm_dofs(const BodyLimb& arm, bool turning) {
  std::vector<int> dofs{arm.flexion, arm.abduction, arm.rotation, arm.hinge};
  if (!turning) return dofs;
  SHG_CHECK(arm.has_wrist(), "a hand that turns has a wrist");
  for (const int dof : {arm.forearm, arm.wrist_flexion, arm.wrist_deviation}) dofs.push_back(dof);
  return dofs;
}

PosedBody arm_body(const BodyModel& body, const State& start, const BodyLimb& arm, bool turning) {
  BodyDefinition alone;
  State home;
  alone.name = arm.name;
  alone.stature = body.stature();
  int parent = kBaseLink;
  for (const int dof : arm_dofs(arm, turning)) {
    Dof copy = body.dof(dof);
    copy.parent = parent++;
    if (dof == arm.flexion) copy.offset = {};
    alone.dofs.push_back(copy);
    const bool holds = !turning && dof == arm.hinge && holds_more(body, dof);
    alone.masses.push_back(holds ? held_mass(body, start, dof) : body.link_mass(dof));
    alone.mass += alone.masses.back().mass;
    home.angles.push_back(start.angles[static_cast<std::size_t>(dof)]);
  }
  Effector hand = body.effectors()[static_cast<std::size_t>(arm.effector)];
  if (!turning) hand.point = held_place(body, start, arm.hinge, hand.link) * hand.point;
  hand.link = static_cast<int>(alone.dofs.size()) - 1;
  hand.limb_root = 0;
  alone.effectors = {hand};
  return {BodyModel(std::move(alone)), std::move(home)};
}

std::vector<double> inverse_weights(const ArmWeights& weights) {
  std::vector<double> inverse;
  for (const JointWeight& joint : weights) {
    inverse.push_back(joint.locked ? 0.0 : 1.0 / joint.weight);
  }
  return inverse;
}

}  // namespace shigusa
