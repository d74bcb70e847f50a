// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/parameters.hpp>
#include <utility>

#include "body/posture_modes.hpp"
#include "core/check.hpp"
#include "plan/held_input.hpp"

namespace shigusa {

Parameters uniform_parameters(const BodyModel& body) {
  return {std::vector<JointWeight>(body.dofs().size()), {}};
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
    : weights_(inverse_weights(parameters)),
      posture_(parameters.posture),
      supports_(parameters.supports) {
  if (!posture_.modes.empty()) change_ = posture_change(body, posture_);
}

MotionInput<double> HeldInput::input() const {
  MotionInput<double> input(weights_);
  if (!change_.empty()) {
    input = {weights_, change_, posture_.timing};
  }
  input.supports = supports_;
  return input;
}

}  // namespace shigusa
