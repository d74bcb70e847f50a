// SPDX-License-Identifier: MIT
#include "layers/arm_motion.hpp"

#include <algorithm>
#include <utility>

#include "core/check.hpp"
#include "person/segment_mass.hpp"

namespace shigusa {
namespace {

constexpr int kStepsPerFrame = 3;

// The mass of the elbow's link with all links that it holds.
MassProperties held_mass(const BodyModel& body, int elbow) {
  LinkMass sum = link_mass(body.link_mass(elbow));
  for (int link = elbow + 1; link < body.dof_count(); ++link) {
    if (!body.moves(elbow, link)) continue;
    const Transformd back = inverse(held_place(body, elbow, link));
    sum.add(link_mass(link_mass(body.link_mass(link)).in_frame(back.rotation, back.translation)));
  }
  const Mat3d upright{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return sum.mass > 0.0 ? sum.in_frame(upright, {}) : MassProperties{};
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

BodyModel arm_body(const BodyModel& body, const BodyLimb& arm, bool turning) {
  BodyDefinition alone;
  alone.name = arm.name;
  alone.stature = body.stature();
  int parent = kBaseLink;
  for (const int dof : arm_dofs(arm, turning)) {
    Dof copy = body.dof(dof);
    copy.parent = parent++;
    if (dof == arm.flexion) copy.offset = {};
    alone.dofs.push_back(copy);
    const bool holds = !turning && dof == arm.hinge && holds_more(body, dof);
    alone.masses.push_back(holds ? held_mass(body, dof) : body.link_mass(dof));
    alone.mass += alone.masses.back().mass;
    alone.start.push_back(body.start()[static_cast<std::size_t>(dof)]);
  }
  Effector hand = body.effectors()[static_cast<std::size_t>(arm.effector)];
  if (!turning) hand.point = held_place(body, arm.hinge, hand.link) * hand.point;
  hand.link = static_cast<int>(alone.dofs.size()) - 1;
  hand.limb_root = 0;
  alone.effectors = {hand};
  return BodyModel(std::move(alone));
}

ArmRollout::ArmRollout(const BodyModel& arm) : arm_(&arm), placed_(arm), ik_(arm) {
  SHG_CHECK(arm.dof_count() == kArmDofs, "an arm has four freedoms");
}

double ArmRollout::run(std::span<const Vec3d> path, const ArmWeights& weights,
                       std::vector<double>& angles) {
  std::array<double, kArmDofs> inverse{};
  for (std::size_t k = 0; k < inverse.size(); ++k) {
    inverse[k] = weights[k].locked ? 0.0 : 1.0 / weights[k].weight;
  }
  std::array<double, kArmDofs> q{};
  std::copy(arm_->start().begin(), arm_->start().end(), q.begin());
  const Effector& hand = arm_->effectors()[0];
  IkTarget<double> target{.link = hand.link, .point = hand.point};
  const IkSettings settings;
  angles.assign(q.begin(), q.end());
  forward_kinematics<double>(*arm_, q, placed_);
  double worst = 0.0;
  for (std::size_t f = 1; f < path.size(); ++f) {
    target.position = path[f];
    double miss = 0.0;
    const int most = f + 1 == path.size() ? kStepsPerFrame + kLastSteps : kStepsPerFrame;
    for (int k = 0; k < most && (k < kStepsPerFrame || miss > kLastTolerance); ++k) {
      const auto change =
          weighted_ik_step<double>(*arm_, placed_, {std::span(&target, 1), inverse}, settings, ik_);
      for (std::size_t d = 0; d < q.size(); ++d) q[d] += change[d];
      forward_kinematics<double>(*arm_, q, placed_);
      miss = norm(position_error(placed_, target));
    }
    target.lag = miss;
    // NaN counts as far off
    worst = miss < 1e9 ? max(worst, miss) : 1e9;
    angles.insert(angles.end(), q.begin(), q.end());
  }
  return worst;
}

}  // namespace shigusa
