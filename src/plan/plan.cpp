// SPDX-License-Identifier: MIT
#include "plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/error.hpp>
#include <utility>

#include "body/posture_modes.hpp"
#include "core/index.hpp"
#include "core/say.hpp"

namespace shigusa {
namespace {

constexpr std::array kLimbDofs{&BodyLimb::flexion, &BodyLimb::abduction, &BodyLimb::rotation,
                               &BodyLimb::hinge};

void add_weights(const BodyModel& body, Layer& layer) {
  for (std::size_t d = 0; d < body.dofs().size(); ++d) {
    layer.parameters.push_back(
        parameter_info(ParameterKind::weight, body.dofs()[d].name, {static_cast<int>(d)}));
  }
}

void add_modes(const BodyModel& body, Layer& layer) {
  const std::vector<PostureMode> modes = posture_modes(body);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    ParameterInfo mode = parameter_info(ParameterKind::mode, modes[m].name, {static_cast<int>(m)});
    mode.sentence = modes[m].sentence;
    mode.shown_low = modes[m].lower;
    mode.shown_high = modes[m].upper;
    layer.parameters.push_back(std::move(mode));
  }
}

void add_timing(Layer& layer) {
  for (std::size_t k = 0; k < kTimings; ++k) {
    const TimingNumber& number = kTimingNumbers[k];
    layer.parameters.push_back(within(
        parameter_info(ParameterKind::timing, std::string(number.name), {static_cast<int>(k)}),
        number.low, number.high));
    layer.parameters.back().sentence = number.sentence;
  }
}

void add_supports(std::span<const Support> supports, Layer& layer) {
  for (std::size_t k = 0; k < supports.size(); ++k) {
    layer.parameters.push_back(
        parameter_info(ParameterKind::support, supports[k].effector, {static_cast<int>(k)}));
  }
}

// Whether a layer's dof belongs to a limb.
bool is_of(const BodyModel& body, const BodyLimb& limb, const std::string& dof) {
  return std::any_of(kLimbDofs.begin(), kLimbDofs.end(),
                     [&](int BodyLimb::*member) { return body.dof(limb.*member).name == dof; });
}

// Adds the layers of idle limbs, with the parameters of those limbs alone.
void add_idle_layers(const BodyModel& body, std::span<const Layer> all, std::span<const Goal> goals,
                     Plan& layers) {
  for (Layer layer : all.subspan(1)) {
    const auto has = [&](const ParameterInfo& info) {
      const std::string& dof = layer.body.dofs[index(info.applies_to[0])].name;
      return std::any_of(all[0].delegates.begin(), all[0].delegates.end(),
                         [&](const Delegate& handed) {
                           const BodyLimb& limb = all[0].body.limbs[index(handed.limb)].joints;
                           return handed.idle == layer.name && is_of(body, limb, dof) &&
                                  std::none_of(goals.begin(), goals.end(), [&](const Goal& goal) {
                                    return body.find_effector(goal.effector) == limb.effector;
                                  });
                         });
    };
    const bool idle = std::any_of(all[0].delegates.begin(), all[0].delegates.end(),
                                  [&](const Delegate& limb) { return limb.idle == layer.name; });
    if (!idle) continue;
    std::erase_if(layer.parameters, [&has](const ParameterInfo& info) { return !has(info); });
    layers.push_back(std::move(layer));
  }
}

}  // namespace

Result<Plan> layers_to_goals(const BodyModel& body, const State& start, std::span<const Goal> goals,
                             const LayerChoice& choice, const CriteriaSettings& criteria) {
  SHG_TRY_ASSIGN(const Plan all, make_layers(body, start, choice, criteria));
  const BodyLimbs limbs = find_limbs(body, start).value();
  std::vector<std::string> names;
  for (const Effector& effector : body.effectors()) names.push_back(effector.name);
  Plan layers{all[0]};
  for (const Goal& goal : goals) {
    const auto effector = body.find_effector(goal.effector);
    const auto arm = std::find_if(limbs.arms.begin(), limbs.arms.end(), [&](const BodyLimb& limb) {
      return effector && limb.effector == *effector;
    });
    if (arm == limbs.arms.end()) {
      return fail(ErrorCode::not_found, unknown_name("effector", goal.effector, names), "goal");
    }
    const bool turns = goal.rotation || goal.axis;
    const bool turnable = choice.stack == LayerStack::human && arm->has_wrist();
    if ((turns && !turnable) || goal.tolerance != Vec3d{}) {
      return fail(ErrorCode::unsupported, say("hands_alone"), "goal of " + goal.effector);
    }
    // the arms' layers follow the upper one in the order of the arms
    layers.push_back(all[1 + index(static_cast<int>(arm - limbs.arms.begin()))]);
  }
  add_idle_layers(body, all, goals, layers);
  return layers;
}

Plan whole_body_plan(const BodyModel& body, std::span<const Support> supports) {
  Layer layer{.name = "whole_body", .body = {}, .parameters = {}, .criteria = {}, .delegates = {}};
  add_weights(body, layer);
  add_modes(body, layer);
  add_timing(layer);
  add_supports(supports, layer);
  return {std::move(layer)};
}

ParameterList parameter_list(std::span<const Layer> plan) {
  ParameterList list;
  for (const Layer& layer : plan) {
    for (const ParameterInfo& info : layer.parameters) {
      list.all.push_back(info);
      if (&layer != plan.data()) list.all.back().layer = layer.name;
    }
  }
  return list;
}

}  // namespace shigusa
