// SPDX-License-Identifier: MIT
#include <shigusa/core/check.hpp>
#include <shigusa/rollout/parameters.hpp>

namespace shigusa {

Parameters uniform_parameters(const BodyModel& body) {
  return {std::vector<JointWeight>(body.dofs().size())};
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

}  // namespace shigusa
