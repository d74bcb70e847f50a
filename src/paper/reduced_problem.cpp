// SPDX-License-Identifier: MIT
#include "paper/reduced_problem.hpp"

#include <algorithm>
#include <numeric>

#include "core/check.hpp"
#include "core/index.hpp"
#include "paper/reduced_motion.hpp"

namespace shigusa {
namespace {

std::vector<int> chain_to(const ReducedBody& body, int link) {
  std::vector<int> chain;
  for (int d = link; d >= 0; d = body.dofs[index(d)].parent) chain.push_back(d);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

ReducedPlacement<double> start_placement(const ReducedBody& body) {
  std::vector<double> start;
  for (const ReducedDof& dof : body.dofs) start.push_back(dof.start);
  std::vector<int> all(start.size());
  std::iota(all.begin(), all.end(), 0);
  ReducedPlacement<double> placed(start.size());
  ReducedLinks<double>(body, all).place(start, placed);
  return placed;
}

ReducedProblem::ReducedProblem(const ReducedBody& of_body, const ReachProblem& problem)
    : body(&of_body), reach(&problem) {
  for (const ReachGoal& goal : problem.goals) add_hand(goal.effector);
  SHG_CHECK(targets.size() == problem.goals.size(), "each goal is for an arm of the layer's body");
  for (const ReducedLimb& limb : body->limbs) {
    if (limb.joints.kind != LimbKind::leg) continue;
    ++legs;
    moving.push_back(static_cast<int>(&limb - body->limbs.data()));
    if (!limb.joints.carries) add_planted_foot(limb);
  }
  int rows = 0;
  for (const Target& target : targets) rows += target.contact ? 6 : 3;
  SHG_CHECK(rows <= kMaxIkRows, "too many goals for one motion");
  find_used();
  for (int frame = 0; frame <= problem.steps; ++frame) {
    const double tau = static_cast<double>(frame) / problem.steps;
    for (const ReachGoal& goal : problem.goals) paths.push_back(goal.path.at(tau));
  }
}

ReducedProblem::~ReducedProblem() = default;

void ReducedProblem::add_hand(int effector) {
  for (const ReducedLimb& limb : body->limbs) {
    if (limb.joints.kind != LimbKind::arm || limb.joints.effector != effector) continue;
    const auto number = static_cast<int>(&limb - body->limbs.data());
    moving.push_back(number);
    targets.push_back({.link = limb.slide,
                       .limb = number,
                       .carrier = limb.carrier,
                       .chain = chain_to(*body, limb.slide)});
    add_clavicle(limb);
  }
}

void ReducedProblem::add_clavicle(const ReducedLimb& limb) {
  const bool by_law = reach->posture_law && nods(*reach->body);
  if (!by_law || limb.elevation < 0 || limb.protraction < 0) return;
  const Vec3d along = arm_in_chest(*body, start_placement(*body), limb.slide, limb.elevation);
  const auto shrug = shrugged(along);
  clavicles.push_back(
      {.slide = limb.slide,
       .elevation = limb.elevation,
       .protraction = limb.protraction,
       .elevation_start = body->dofs[index(limb.elevation)].start - shrug.elevation,
       .protraction_start = body->dofs[index(limb.protraction)].start - shrug.protraction});
}

void ReducedProblem::add_planted_foot(const ReducedLimb& leg) {
  // the last of the ankle's dofs, which follow the slide
  const int foot = leg.slide + (leg.joints.inversion < 0 ? 1 : 2);
  const ReducedPlacement<double> start = start_placement(*body);
  targets.push_back({.link = foot,
                     .contact = true,
                     .position = start.origin[index(foot)],
                     .orientation = start.rotation[index(foot)],
                     .chain = chain_to(*body, foot)});
}

void ReducedProblem::find_used() {
  std::vector<bool> chained(body->dofs.size(), false);
  for (const Target& target : targets) {
    for (const int d : target.chain) chained[index(d)] = true;
  }
  for (std::size_t d = 0; d < body->dofs.size(); ++d) {
    if (!chained[d]) continue;
    const ReducedDof& dof = body->dofs[d];
    const bool has_limits = dof.lower > -kUnlimited || dof.upper < kUnlimited;
    used.push_back(static_cast<int>(d));
    if (has_limits && reach->hold_limits) limited.push_back(static_cast<int>(d));
  }
}

}  // namespace shigusa
