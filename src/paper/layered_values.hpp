// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/parameters.hpp>
#include <span>
#include <vector>

#include "plan/plan.hpp"

namespace shigusa {

// Weight of one dof.
struct JointWeight {
  double weight = 1.0;  // > 0; the larger, the less the dof moves relative to others
  bool locked = false;  // the dof keeps its start angle

  friend bool operator==(const JointWeight&, const JointWeight&) = default;
};

// The dofs of an arm moved by weights.
inline constexpr int kArmDofs = 4;
// The weights of shoulder flexion, abduction and rotation, and of elbow flexion.
using ArmWeights = std::array<JointWeight, kArmDofs>;

// The values of a plan of several layers, in the form used by its layers.
struct LayeredValues {
  std::vector<JointWeight> joints;     // (dofs of the first layer's body)
  std::vector<double> contractions{};  // (its limbs) 0..kContractionMax
  std::vector<ArmWeights> arms{};      // (goals whose arm moves by weights)
  std::vector<double> swivels{};       // (goals whose arm moves by its swivel) rad
  std::vector<double> finals{};        // (searched final angles) rad

  friend bool operator==(const LayeredValues&, const LayeredValues&) = default;
};

// The values of a plan in the form used by its layers; dofs without a weight are locked.
[[nodiscard]] LayeredValues layered_values(std::span<const Layer> layers,
                                           const Parameters& parameters);
// The reverse; a contraction shared by several limbs is taken from the last.
[[nodiscard]] Parameters parameters_of(std::span<const Layer> layers, LayeredValues values);

// The initial values of the layers.
[[nodiscard]] LayeredValues start_values(std::span<const Layer> layers);

}  // namespace shigusa
