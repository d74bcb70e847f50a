// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/parameters.hpp>
#include <utility>

#include "body/posture_modes.hpp"
#include "core/check.hpp"
#include "plan/held_input.hpp"
#include "plan/plan.hpp"

namespace shigusa {

Parameters uniform_parameters(const BodyModel& body) {
  return parameter_list(whole_body_plan(body)).start();
}

Parameters decode_paper_genes(const BodyModel& body, std::span<const std::uint16_t> genes) {
  SHG_CHECK(genes.size() == body.dofs().size(), "one gene for each freedom");
  Parameters parameters = uniform_parameters(body);
  for (std::size_t d = 0; d < genes.size(); ++d) {
    parameters.locked[d] = genes[d] == 0;
    if (genes[d] != 0) parameters.values[d] = genes[d];
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

std::vector<double> inverse_weights(const BodyModel& body, const Parameters& parameters) {
  std::vector<double> inverse;
  for (std::size_t d = 0; d < body.dofs().size(); ++d) {
    SHG_CHECK(parameters.values[d] > 0.0, "weights are positive");
    inverse.push_back(parameters.locked[d] ? 0.0 : 1.0 / parameters.values[d]);
  }
  return inverse;
}

std::vector<double> posture_change(const BodyModel& body, std::span<const double> values) {
  const std::vector<PostureMode> modes = posture_modes(body);
  SHG_CHECK(values.size() == modes.size(), "one value for each posture mode");
  std::vector<double> change(body.dofs().size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (std::size_t d = 0; d < change.size(); ++d) {
      change[d] += values[m] * modes[m].direction[d];
    }
  }
  return change;
}

HeldInput::HeldInput(const BodyModel& body, const Parameters& parameters, std::size_t supports)
    : weights_(inverse_weights(body, parameters)) {
  const std::span<const double> values(parameters.values);
  const std::size_t after = kTimings + supports;
  SHG_CHECK(values.size() >= weights_.size() + after, "values of the whole body's plan");
  const std::size_t timings = values.size() - after;
  supports_.assign(values.end() - static_cast<std::ptrdiff_t>(supports), values.end());
  if (!parameters.posed) return;
  change_ = posture_change(body, values.subspan(weights_.size(), timings - weights_.size()));
  for (std::size_t k = 0; k < kTimings; ++k) {
    timing_.*kTimingMembers<double>[k] = values[timings + k];
  }
}

MotionInput<double> HeldInput::input() const {
  MotionInput<double> input(weights_);
  if (!change_.empty()) input = {weights_, change_, timing_};
  input.supports = supports_;
  return input;
}

}  // namespace shigusa
