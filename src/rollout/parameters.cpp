// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/body/posture_modes.hpp>
#include <shigusa/core/check.hpp>
#include <shigusa/rollout/held_input.hpp>
#include <shigusa/rollout/parameters.hpp>
#include <utility>

namespace shigusa {

Parameters uniform_parameters(const BodyModel& body) {
  return {std::vector<JointWeight>(body.dofs().size()), {}};
}

FixedParameters no_fixed_parameters(const BodyModel& body) {
  FixedParameters fixed{uniform_parameters(body), std::vector<bool>(body.dofs().size()), {}};
  fixed.posture.resize(posture_members(body, fixed.values.posture).size());
  return fixed;
}

Parameters decode_paper_genes(std::span<const std::uint16_t> genes) {
  Parameters parameters;
  for (const std::uint16_t gene : genes) {
    parameters.joints.push_back(gene == 0 ? JointWeight{1.0, true}
                                          : JointWeight{static_cast<double>(gene), false});
  }
  return parameters;
}

std::vector<float> inverse_weights_of_genes(std::span<const std::uint16_t> genes) {
  std::vector<float> inverse;
  inverse.reserve(genes.size());
  for (const std::uint16_t gene : genes) {
    inverse.push_back(gene == 0 ? 0.0F : 1.0F / static_cast<float>(gene));
  }
  return inverse;
}

std::vector<double> inverse_weights(const Parameters& parameters) {
  std::vector<double> inverse;
  for (const JointWeight& joint : parameters.joints) {
    SHG_CHECK(joint.weight > 0.0, "weights are positive");
    inverse.push_back(joint.locked ? 0.0 : 1.0 / joint.weight);
  }
  return inverse;
}

std::vector<PostureMember> mode_members(const BodyModel& body, std::vector<double>& values) {
  const std::vector<PostureMode> modes = posture_modes(body);
  values.resize(modes.size());
  std::vector<PostureMember> members;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    members.push_back({modes[m].name, &values[m], -kPostureMax, kPostureMax, true});
  }
  return members;
}

std::vector<PostureMember> posture_members(const BodyModel& body, PostureParameters& posture) {
  std::vector<PostureMember> members = mode_members(body, posture.modes);
  for (std::size_t k = 0; k < kTimings; ++k) {
    const TimingNumber& number = kTimingNumbers[k];
    double* value = &(posture.timing.*kTimingMembers<double>[k]);
    members.push_back({std::string(number.name), value, number.low, number.high});
  }
  return members;
}

std::vector<PostureMember> posture_members(const BodyModel& body, Parameters& parameters) {
  std::vector<PostureMember> members = posture_members(body, parameters.posture);
  if (!parameters.later) return members;
  for (PostureMember& member : mode_members(body, parameters.later->modes)) {
    member.name.insert(0, kLaterPrefix);
    members.push_back(std::move(member));
  }
  members.push_back(
      {std::string(kSwitchName), &parameters.later->switch_at, kSwitchMin, kSwitchMax});
  return members;
}

void add_later_phase(Parameters& parameters) {
  if (parameters.later) return;
  parameters.later = {.joints = parameters.joints, .modes = parameters.posture.modes};
}

std::vector<double> posture_change(const BodyModel& body, const PostureParameters& posture) {
  const std::vector<PostureMode> modes = posture_modes(body);
  SHG_CHECK(posture.modes.size() == modes.size(), "one value for each posture mode");
  std::vector<double> change(body.dofs().size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (std::size_t d = 0; d < change.size(); ++d) {
      change[d] += posture.modes[m] * modes[m].direction[d];
    }
  }
  return change;
}

HeldInput::HeldInput(const BodyModel& body, const Parameters& parameters)
    : weights_(inverse_weights(parameters)), posture_(parameters.posture) {
  if (!posture_.modes.empty()) change_ = posture_change(body, posture_);
  if (!parameters.later) return;
  later_weights_ = inverse_weights({.joints = parameters.later->joints});
  switch_at_ = parameters.later->switch_at;
  const std::vector<double>& later_modes = parameters.later->modes;
  if (!later_modes.empty()) later_change_ = posture_change(body, {.modes = later_modes});
  // a phase of weights alone beside one with a posture is drawn nowhere
  const std::size_t dofs = std::max(change_.size(), later_change_.size());
  change_.resize(dofs);
  later_change_.resize(dofs);
}

MotionInput<double> HeldInput::input() const {
  MotionInput<double> input(weights_);
  if (!change_.empty()) {
    input = {weights_, change_, posture_.timing};
  }
  input.later = {later_weights_, later_change_, switch_at_};
  return input;
}

}  // namespace shigusa
