// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "criteria/built_in_criteria.hpp"
#include "plan/layer.hpp"
#include "rollout/posture_law.hpp"

namespace shigusa {
namespace {

constexpr const char* kRest = "rest";

// Range of the final angles of a free arm (rad): within its joints' limits and not across the body.
// It includes the start posture, even beyond these bounds.
struct FinalRange {
  int BodyLimb::*dof;
  double low;
  double high;
};
constexpr std::array<FinalRange, 3> kFinalRanges{{
    {&BodyLimb::flexion, radians(-60.0), radians(120.0)},
    {&BodyLimb::abduction, radians(-5.0), radians(100.0)},
    {&BodyLimb::hinge, 0.0, radians(120.0)},
}};

// Criteria for swivels, which differ by the arm's posture and the smoothness of its motion, and
// little by torque.
CriteriaSettings swivel_criteria() {
  // an arm alone has neither trunk nor feet, and its swivel moves neither hand nor shoulder
  CriteriaSettings criteria{{CriterionKind::torque, 0.1}};
  const CriteriaSettings usual = default_criteria();
  for (const CriterionKind kind : {CriterionKind::joint_range, CriterionKind::discomfort,
                                   CriterionKind::joint_acceleration, CriterionKind::feasibility}) {
    criteria[kind] = usual[kind];
  }
  return criteria;
}

// Criteria of a free limb's own motion, beside the whole body's.
CriteriaSettings rest_criteria() { return {{CriterionKind::torque, 0.5}}; }

// Replaces the parameters of the paper's layer of an arm by its swivel.
void search_swivel(Layer& layer) {
  layer.parameters = {
      within(parameter_info(ParameterKind::swivel, layer.name, {0, 1, 2}), kSwivelMin, kSwivelMax)};
  layer.criteria = swivel_criteria();
}

// Adds an arm to the idle layer, with the final angles that are searched.
void add_idle_arm(const BodyModel& body, const BodyLimb& arm, const Layer& alone, Layer& rest) {
  const auto first = static_cast<int>(rest.body.dofs.size());
  for (ReducedDof dof : alone.body.dofs) {
    if (dof.parent >= 0) dof.parent += first;
    rest.body.dofs.push_back(std::move(dof));
  }
  // a shoulder moved by PostureLaw has no final angle of its own
  const bool drawn = nods(body);
  for (const FinalRange& range : kFinalRanges) {
    if (drawn && range.dof != &BodyLimb::hinge) continue;
    const Dof& dof = body.dof(arm.*range.dof);
    const auto at =
        std::find_if(rest.body.dofs.begin() + first, rest.body.dofs.end(),
                     [&dof](const ReducedDof& reduced) { return reduced.name == dof.name; });
    ParameterInfo final = parameter_info(ParameterKind::final_angle, dof.name,
                                         {static_cast<int>(at - rest.body.dofs.begin())});
    final.start = at->start;
    rest.parameters.push_back(within(std::move(final),
                                     std::min(std::max(range.low, dof.lower), at->start),
                                     std::max(std::min(range.high, dof.upper), at->start)));
  }
}

}  // namespace

Result<std::vector<Layer>> human_layers(const BodyModel& body, const State& start,
                                        const CriteriaSettings& criteria, LayerReading reading) {
  SHG_TRY_ASSIGN(std::vector<Layer> layers, paper_layers(body, start, criteria, reading));
  for (Delegate& handed : layers[0].delegates) {
    if (handed.by != DelegateMethod::limb_library) continue;
    handed.by = DelegateMethod::swivel;
    handed.idle = kRest;
  }
  for (ReducedLimb& limb : layers[0].body.limbs) {
    if (limb.joints.kind == LimbKind::arm) limb.law = LengthLaw::path;
  }
  Layer rest{
      .name = kRest, .body = {}, .parameters = {}, .criteria = rest_criteria(), .delegates = {}};
  const BodyLimbs limbs = find_limbs(body, start).value();
  for (std::size_t a = 0; a < limbs.arms.size(); ++a) {
    Layer& arm = layers[1 + a];
    add_idle_arm(body, limbs.arms[a], arm, rest);
    search_swivel(arm);
  }
  layers.push_back(std::move(rest));
  return layers;
}

Result<std::vector<Layer>> make_layers(const BodyModel& body, const State& start,
                                       const LayerChoice& choice,
                                       const CriteriaSettings& criteria) {
  switch (choice.stack) {
    case LayerStack::paper:
      return paper_layers(body, start, criteria, choice.reading);
    case LayerStack::human:
      break;
  }
  return human_layers(body, start, criteria, choice.reading);
}

bool searches(const Layer& layer, ParameterKind kind) {
  return std::any_of(layer.parameters.begin(), layer.parameters.end(),
                     [kind](const ParameterInfo& info) { return info.kind == kind; });
}

}  // namespace shigusa
