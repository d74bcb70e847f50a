// SPDX-License-Identifier: MIT
#include "core/check.hpp"
#include "core/index.hpp"
#include "paper/reduced_motion.hpp"

namespace shigusa {
namespace {

// `value`(gene, kind): a contraction, or a weight, which is 0 for locked.
template <class Value>
LayeredValues decode(const Layer& layer, Value&& value) {
  LayeredValues parameters;
  parameters.joints.assign(layer.body.dofs.size(), {.weight = 1.0, .locked = true});
  parameters.contractions.assign(layer.body.limbs.size(), 0.0);
  for (std::size_t g = 0; g < layer.parameters.size(); ++g) {
    const ParameterInfo& info = layer.parameters[g];
    const double decoded = value(g, info.kind);
    for (const int to : info.applies_to) {
      if (info.kind == ParameterKind::contraction) {
        parameters.contractions[index(to)] = decoded;
      } else if (decoded > 0.0) {
        parameters.joints[index(to)] = {decoded, false};
      }
    }
  }
  return parameters;
}

}  // namespace

LayeredValues decode_layer_genes(const Layer& layer, std::span<const std::uint16_t> genes) {
  SHG_CHECK(genes.size() == layer.parameters.size(),
            "one number for each parameter of layer " + layer.name);
  return decode(layer,
                [&](std::size_t gene, ParameterKind) { return static_cast<double>(genes[gene]); });
}

LayeredValues decode_layer_point(const Layer& layer, std::span<const double> point) {
  SHG_CHECK(point.size() == layer.parameters.size(),
            "one number for each parameter of layer " + layer.name);
  return decode(layer, [&](std::size_t gene, ParameterKind kind) {
    if (kind == ParameterKind::contraction) return kContractionMax * point[gene];
    return exponential(kLogWeightRange * (2.0 * point[gene] - 1.0));
  });
}

}  // namespace shigusa
