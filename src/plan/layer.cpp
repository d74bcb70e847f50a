// SPDX-License-Identifier: MIT
#include "plan/layer.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "body/joint_name.hpp"

namespace shigusa {
namespace {

void add_weight(Layer& layer, int dof) {
  const std::vector<ReducedDof>& dofs = layer.body.dofs;
  const std::string& name = dofs[static_cast<std::size_t>(dof)].name;
  // for both sides
  const bool shared = std::any_of(dofs.begin(), dofs.end(), [&](const ReducedDof& other) {
    return other.weight_of == dof && without_side(other.name) == without_side(name);
  });
  layer.parameters.push_back(parameter_info(
      ParameterKind::weight, std::string(shared ? without_side(name) : name), {dof}));
}

// Whether a dof belongs to a clavicle that follows its arm, without a weight.
bool follows_arm(const ReducedBody& body, int dof) {
  return std::any_of(body.limbs.begin(), body.limbs.end(), [dof](const ReducedLimb& limb) {
    return limb.elevation == dof || limb.protraction == dof;
  });
}

bool is_trunk_joint(const ReducedBody& body, int dof) {
  return std::any_of(body.joints.begin(), body.joints.end(),
                     [dof](const TrunkJoint& joint) { return joint.dof == dof; });
}

// Adds one weight for each dof that is no length and has a weight of its own, in the body's order.
void add_weights(Layer& layer, LayerReading reading) {
  for (std::size_t d = 0; d < layer.body.dofs.size(); ++d) {
    const ReducedDof& dof = layer.body.dofs[d];
    if (dof.kind == ReducedDof::Kind::slide || dof.weight_of >= 0) continue;
    if (follows_arm(layer.body, static_cast<int>(d))) continue;
    const bool of_hip = dof.axis == Axis::y && !is_trunk_joint(layer.body, static_cast<int>(d));
    if (reading == LayerReading::contraction_a_limb && of_hip) continue;
    add_weight(layer, static_cast<int>(d));
  }
}

void add_contractions(Layer& layer, LayerReading reading) {
  const auto limbs_of = [&layer](LimbKind kind) {
    std::vector<int> limbs;
    for (std::size_t i = 0; i < layer.body.limbs.size(); ++i) {
      if (layer.body.limbs[i].joints.kind == kind) limbs.push_back(static_cast<int>(i));
    }
    return limbs;
  };
  for (const auto& [kind, name] : {std::pair{LimbKind::leg, "legs"}, {LimbKind::arm, "arms"}}) {
    const std::vector<int> limbs = limbs_of(kind);
    if (reading == LayerReading::shared_contractions) {
      layer.parameters.push_back(parameter_info(ParameterKind::contraction, name, limbs));
      continue;
    }
    for (const int limb : limbs) {
      const std::string& of = layer.body.limbs[static_cast<std::size_t>(limb)].joints.name;
      layer.parameters.push_back(parameter_info(ParameterKind::contraction, of, {limb}));
    }
  }
}

// The arm alone, attached to the trunk (paper, section 3.4): four hinges.
Layer arm_layer(const BodyModel& body, const State& start, const BodyLimb& arm) {
  Layer layer{.name = arm.name, .body = {}, .parameters = {}, .criteria = {}, .delegates = {}};
  layer.criteria[CriterionKind::balance].weight =
      0.0;  // with a fixed trunk there is nothing to balance
  int parent = -1;
  for (const int dof : {arm.flexion, arm.abduction, arm.rotation, arm.hinge}) {
    const Dof& from = body.dof(dof);
    layer.body.dofs.push_back({.name = from.name,
                               .parent = parent,
                               .offset = from.offset,
                               .axis = from.axis,
                               .sign = from.sign,
                               .start = start.angles[static_cast<std::size_t>(dof)]});
    parent = static_cast<int>(layer.body.dofs.size()) - 1;
    add_weight(layer, parent);
  }
  return layer;
}

}  // namespace

Result<std::vector<Layer>> paper_layers(const BodyModel& body, const State& start,
                                        const CriteriaSettings& criteria, LayerReading reading) {
  SHG_TRY_ASSIGN(const BodyLimbs limbs, find_limbs(body, start));
  Layer upper{.name = "trunk_and_limb_lengths",
              .body = reduced_body(body, start, limbs),
              .parameters = {},
              .criteria = criteria,
              .delegates = {}};
  add_weights(upper, reading);
  add_contractions(upper, reading);
  for (std::size_t i = 0; i < upper.body.limbs.size(); ++i) {
    const BodyLimb& limb = upper.body.limbs[i].joints;
    const bool leg = limb.kind == LimbKind::leg;
    upper.delegates.push_back({static_cast<int>(i),
                               leg ? DelegateMethod::closed_form : DelegateMethod::limb_library,
                               leg ? "" : limb.name});
  }
  std::vector<Layer> layers{std::move(upper)};
  for (const BodyLimb& arm : limbs.arms) layers.push_back(arm_layer(body, start, arm));
  return layers;
}

}  // namespace shigusa
