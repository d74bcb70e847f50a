// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/parameters.hpp>
#include <span>
#include <vector>

#include "plan/plan.hpp"

namespace shigusa {

// How readily one joint freedom moves.
struct JointWeight {
  double weight = 1.0;  // > 0; the larger, the less the freedom moves beside the others
  bool locked = false;  // it keeps its start angle

  friend bool operator==(const JointWeight&, const JointWeight&) = default;
};

// The freedoms of an arm that moves by weights.
inline constexpr int kArmDofs = 4;
// The weights of shoulder flexion, abduction and rotation, and of elbow flexion.
using ArmWeights = std::array<JointWeight, kArmDofs>;

// The values of a plan of several layers, as these compute with them.
struct LayeredValues {
  std::vector<JointWeight> joints;     // (dofs of the first layer's body)
  std::vector<double> contractions{};  // (its limbs) 0..kContractionMax
  std::vector<ArmWeights> arms{};      // (goals whose arm moves by weights)
  std::vector<double> swivels{};       // (goals whose arm moves by its swivel) rad
  std::vector<double> finals{};        // (final angles that layers search) rad

  friend bool operator==(const LayeredValues&, const LayeredValues&) = default;
};

// The values of a plan as its layers compute with them; a freedom that has no weight in it is
// locked.
[[nodiscard]] LayeredValues layered_values(std::span<const Layer> layers,
                                           const Parameters& parameters);
// The reverse; of a contraction that limbs share, the last one's.
[[nodiscard]] Parameters parameters_of(std::span<const Layer> layers, LayeredValues values);

// The values that layers begin with.
[[nodiscard]] LayeredValues start_values(std::span<const Layer> layers);

}  // namespace shigusa
