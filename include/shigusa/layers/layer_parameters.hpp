// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/rollout/parameters.hpp>
#include <vector>

namespace shigusa {

// The numbers that a layer's motion is made from: its genes, decoded.
struct LayerParameters {
  std::vector<JointWeight> joints;  // (dofs of the layer's body); a slide's means nothing
  // (limbs) 0..15, where the limb is longest and shortest
  std::vector<double> contractions;

  friend bool operator==(const LayerParameters&, const LayerParameters&) = default;
};

// Freedoms of an arm that moves by weights.
inline constexpr int kArmDofs = 4;

// The weights of shoulder flexion, abduction and rotation, and elbow flexion.
using ArmWeights = std::array<JointWeight, kArmDofs>;

// The numbers that a layered motion is generated from.
struct LayeredParameters {
  LayerParameters upper;           // trunk and limb lengths
  std::vector<ArmWeights> arms{};  // (goals whose arm goes by weights)
  std::vector<double> swivels{};   // (goals whose arm goes by its swivel) rad
  std::vector<double> finals{};    // (final angles that layers search) rad

  friend bool operator==(const LayeredParameters&, const LayeredParameters&) = default;
};

}  // namespace shigusa
