// SPDX-License-Identifier: MIT
#include "paper/layered_values.hpp"

#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {
namespace {

// Values with the numbers of elements of each kind that the layers have.
LayeredValues sized_for(std::span<const Layer> layers) {
  const ReducedBody& upper = layers.front().body;
  LayeredValues values{.joints = std::vector<JointWeight>(upper.dofs.size(), {1.0, true}),
                       .contractions = std::vector<double>(upper.limbs.size())};
  for (const Layer& layer : layers.subspan(1)) {
    if (searches(layer, ParameterKind::weight)) values.arms.emplace_back();
    for (const ParameterInfo& info : layer.parameters) {
      if (info.kind == ParameterKind::swivel) values.swivels.emplace_back();
      if (info.kind == ParameterKind::final_angle) values.finals.emplace_back();
    }
  }
  return values;
}

// Visits each parameter's place: visit(its number, value, lock or null), for a contraction once for
// each limb.
template <class Visit>
void for_each_value(std::span<const Layer> layers, LayeredValues& values, Visit&& visit) {
  std::size_t number = 0;
  auto arm = values.arms.begin();
  auto swivel = values.swivels.begin();
  auto final = values.finals.begin();
  for (const Layer& layer : layers) {
    const bool upper = &layer == layers.data();
    for (const ParameterInfo& info : layer.parameters) {
      const std::size_t of = index(info.applies_to[0]);
      if (info.kind == ParameterKind::weight) {
        JointWeight& joint = upper ? values.joints[of] : (*arm)[of];
        visit(number, joint.weight, &joint.locked);
      } else if (info.kind == ParameterKind::contraction) {
        for (const int limb : info.applies_to) {
          visit(number, values.contractions[index(limb)], nullptr);
        }
      } else {
        visit(number, info.kind == ParameterKind::swivel ? *swivel++ : *final++, nullptr);
      }
      ++number;
    }
    if (!upper && searches(layer, ParameterKind::weight)) ++arm;
  }
}

}  // namespace

LayeredValues layered_values(std::span<const Layer> layers, const Parameters& parameters) {
  LayeredValues values = sized_for(layers);
  for_each_value(layers, values, [&](std::size_t number, double& value, bool* locked) {
    SHG_CHECK(number < parameters.values.size(), "values of the layers' plan");
    value = parameters.values[number];
    if (locked != nullptr) *locked = parameters.locked[number];
  });
  return values;
}

Parameters parameters_of(std::span<const Layer> layers, LayeredValues values) {
  Parameters parameters = parameter_list(layers).start();
  for_each_value(layers, values, [&](std::size_t number, double value, const bool* locked) {
    parameters.values[number] = value;
    if (locked != nullptr) parameters.locked[number] = *locked;
  });
  return parameters;
}

LayeredValues start_values(std::span<const Layer> layers) {
  return layered_values(layers, parameter_list(layers).start());
}

}  // namespace shigusa
