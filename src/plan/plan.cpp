// SPDX-License-Identifier: MIT
#include "plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/words.hpp>
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
        ParameterInfo::named(ParameterKind::weight, body.dofs()[d].name, {static_cast<int>(d)}));
  }
}

void add_modes(const BodyModel& body, Layer& layer) {
  const std::vector<PostureMode> modes = posture_modes(body);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    ParameterInfo mode =
        ParameterInfo::named(ParameterKind::mode, modes[m].name, {static_cast<int>(m)});
    mode.sentence = modes[m].sentence;
    mode.shown_low = modes[m].lower;
    mode.shown_high = modes[m].upper;
    layer.parameters.push_back(std::move(mode));
  }
}

void add_timing(Layer& layer) {
  for (std::size_t k = 0; k < kTimings; ++k) {
    const TimingNumber& number = kTimingNumbers[k];
    layer.parameters.push_back(
        ParameterInfo::named(ParameterKind::timing, std::string(number.name), {static_cast<int>(k)})
            .within(number.low, number.high));
    layer.parameters.back().sentence = number.sentence;
  }
}

void add_supports(std::span<const Support> supports, Layer& layer) {
  for (std::size_t k = 0; k < supports.size(); ++k) {
    layer.parameters.push_back(
        ParameterInfo::named(ParameterKind::support, supports[k].effector, {static_cast<int>(k)}));
  }
}

// How many values of each kind a plan has.
struct Counts {
  std::size_t joints = 0;
  std::size_t modes = 0;
  std::size_t contractions = 0;
  std::size_t arms = 0;
  std::size_t swivels = 0;
  std::vector<double> finals{};  // rad, at the start
  std::size_t supports = 0;
};

std::size_t count_of(const Layer& layer, ParameterKind kind) {
  return static_cast<std::size_t>(
      std::count_if(layer.parameters.begin(), layer.parameters.end(),
                    [kind](const ParameterInfo& info) { return info.kind == kind; }));
}

Counts counts_of(std::span<const Layer> plan) {
  const Layer& first = plan.front();
  const bool whole = moves_whole_body(plan);
  Counts counts{.joints = whole ? count_of(first, ParameterKind::weight) : first.body.dofs.size(),
                .modes = count_of(first, ParameterKind::mode),
                .contractions = first.body.limbs.size(),
                .supports = count_of(first, ParameterKind::support)};
  for (const Layer& layer : plan.subspan(1)) {
    if (searches(layer, ParameterKind::weight)) ++counts.arms;
    if (searches(layer, ParameterKind::swivel)) ++counts.swivels;
    for (const ParameterInfo& info : layer.parameters) {
      if (info.kind != ParameterKind::final_angle) continue;
      counts.finals.push_back(layer.body.dofs[index(info.applies_to[0])].start);
    }
  }
  return counts;
}

bool has_weight(const Layer& layer, std::size_t dof) {
  return std::any_of(
      layer.parameters.begin(), layer.parameters.end(), [dof](const ParameterInfo& info) {
        return info.kind == ParameterKind::weight &&
               std::count(info.applies_to.begin(), info.applies_to.end(), static_cast<int>(dof)) >
                   0;
      });
}

// Gives the parameters of one layer after the other their places.
class Binder {
 public:
  explicit Binder(Parameters& values)
      : values_(values),
        arm_(values.arms.begin()),
        swivel_(values.swivels.begin()),
        final_(values.finals.begin()) {}

  void add(const Layer& layer, bool below) {
    for (const ParameterInfo& info : layer.parameters) {
      Parameter parameter{.layer = &layer, .info = &info, .below = below};
      if (place(info, below, parameter)) parameters_.push_back(std::move(parameter));
    }
    if (below && searches(layer, ParameterKind::weight)) ++arm_;
  }

  std::vector<Parameter> take() { return std::move(parameters_); }

 private:
  // Whether the values have the parameter.
  bool place(const ParameterInfo& info, bool below, Parameter& parameter) {
    const std::size_t first = info.applies_to.empty() ? 0 : index(info.applies_to[0]);
    switch (info.kind) {
      case ParameterKind::weight: {
        JointWeight& joint = below ? (*arm_)[first] : values_.joints[first];
        parameter.values = {&joint.weight};
        parameter.locked = &joint.locked;
        return true;
      }
      case ParameterKind::contraction:
        for (const int limb : info.applies_to) {
          parameter.values.push_back(&values_.contractions[index(limb)]);
        }
        return true;
      case ParameterKind::swivel:
        parameter.values = {&*swivel_++};
        return true;
      case ParameterKind::final_angle:
        parameter.values = {&*final_++};
        return true;
      case ParameterKind::mode: {
        if (values_.posture.modes.empty()) return false;
        parameter.values = {&values_.posture.modes[first]};
        return true;
      }
      case ParameterKind::timing:
        if (values_.posture.modes.empty()) return false;
        parameter.values = {&(values_.posture.timing.*kTimingMembers<double>[first])};
        return true;
      case ParameterKind::support:
        parameter.values = {&values_.supports[first]};
        return true;
    }
    return false;
  }

  Parameters& values_;
  std::vector<ArmWeights>::iterator arm_;
  std::vector<double>::iterator swivel_;
  std::vector<double>::iterator final_;
  std::vector<Parameter> parameters_;
};

Result<void> check_counts(const Counts& counts, const Parameters& values) {
  const auto wrong = [](std::string_view what, std::size_t given, std::size_t known) {
    return fail(ErrorCode::invalid_argument, say("plan_counts", given, what, known));
  };
  if (values.joints.size() != counts.joints) {
    return wrong("joint weights", values.joints.size(), counts.joints);
  }
  if (!values.posture.modes.empty() && values.posture.modes.size() != counts.modes) {
    return wrong("posture values", values.posture.modes.size(), counts.modes);
  }
  if (values.contractions.size() != counts.contractions) {
    return wrong("contractions", values.contractions.size(), counts.contractions);
  }
  if (values.arms.size() != counts.arms) return wrong("arms", values.arms.size(), counts.arms);
  if (values.swivels.size() != counts.swivels) {
    return wrong("swivels", values.swivels.size(), counts.swivels);
  }
  if (values.finals.size() != counts.finals.size()) {
    return wrong("final angles", values.finals.size(), counts.finals.size());
  }
  if (values.supports.size() != counts.supports) {
    return wrong("supports", values.supports.size(), counts.supports);
  }
  return {};
}

Result<void> check_range(const Parameter& parameter) {
  const ParameterInfo& info = *parameter.info;
  const std::string_view word = info_of(info.kind).word;
  const std::string_view what = word.empty() ? "value" : word;
  for (const double* value : parameter.values) {
    if (!(*value >= info.low && *value <= info.high)) {
      return fail(ErrorCode::invalid_argument,
                  say("parameter_range", what, *value, info.low, info.high), parameter.subject());
    }
    if (*value != parameter.value()) {
      return fail(ErrorCode::invalid_argument,
                  say("shared_values", what, parameter.value(), *value), parameter.subject());
    }
  }
  return {};
}

// Whether a layer's freedom is one of a limb.
bool is_of(const BodyModel& body, const BodyLimb& limb, const std::string& dof) {
  return std::any_of(kLimbDofs.begin(), kLimbDofs.end(),
                     [&](int BodyLimb::*member) { return body.dof(limb.*member).name == dof; });
}

// The layers of limbs that no goal moves, with the parameters of those limbs alone.
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

Result<Plan> layers_to_goals(const BodyModel& body, std::span<const Goal> goals,
                             const LayerChoice& choice, const CriteriaSettings& criteria) {
  SHG_TRY_ASSIGN(const Plan all, make_layers(body, choice, criteria));
  const BodyLimbs limbs = find_limbs(body).value();
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

bool moves_whole_body(std::span<const Layer> plan) { return plan.front().body.dofs.empty(); }

std::string Parameter::subject() const {
  const bool of_layer = below && info->kind == ParameterKind::weight;
  return of_layer ? layer->name + "." + info->name : info->name;
}

std::string Parameter::spelled(std::string_view unit) const {
  const ParameterKindInfo& kind = info_of(info->kind);
  std::string text = subject();
  if (!kind.word.empty()) text.append(".").append(kind.word);
  return kind.angle ? text.append(unit) : text;
}

Parameters start_values(std::span<const Layer> plan) {
  const Counts counts = counts_of(plan);
  Parameters values{.joints = std::vector<JointWeight>(counts.joints)};
  for (std::size_t d = 0; d < counts.joints; ++d) {
    values.joints[d].locked = !has_weight(plan.front(), d);
  }
  values.contractions.assign(counts.contractions, 0.0);
  values.arms.assign(counts.arms, {});
  values.swivels.assign(counts.swivels, 0.0);
  values.finals = counts.finals;
  values.supports.assign(counts.supports, 0.0);
  return values;
}

void give_posture(std::span<const Layer> plan, Parameters& values) {
  values.posture.modes.resize(count_of(plan.front(), ParameterKind::mode));
}

std::vector<Parameter> parameters_of(std::span<const Layer> plan, Parameters& values) {
  Binder binder(values);
  for (const Layer& layer : plan) binder.add(layer, &layer != plan.data());
  return binder.take();
}

Result<void> check_parameters(std::span<const Layer> plan, const Parameters& values) {
  SHG_TRY(check_counts(counts_of(plan), values));
  Parameters copy = values;
  for (const Parameter& parameter : parameters_of(plan, copy)) {
    SHG_TRY(check_range(parameter));
  }
  const std::vector<ReducedDof>& dofs = plan.front().body.dofs;
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    if (dofs[d].kind == ReducedDof::Kind::slide || has_weight(plan.front(), d)) continue;
    if (values.joints[d].locked) continue;
    return fail(ErrorCode::invalid_argument, say("not_locked"), dofs[d].name);
  }
  return {};
}

FixedParameters no_fixed_parameters(const BodyModel& body, std::span<const Support> supports) {
  const Plan plan = whole_body_plan(body, supports);
  FixedParameters fixed{start_values(plan), {}};
  give_posture(plan, fixed.values);
  fixed.set.resize(parameters_of(plan, fixed.values).size());
  return fixed;
}

}  // namespace shigusa
