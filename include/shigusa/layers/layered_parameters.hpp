// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/core/result.hpp>
#include <shigusa/layers/arm_motion.hpp>
#include <shigusa/layers/layer_parameters.hpp>
#include <shigusa/layers/reduced_motion.hpp>
#include <shigusa/rollout/goal.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

// One of the numbers that layered parameters consist of, by the name of its gene.
struct LayeredMember {
  std::string layer;  // empty of the upper layer, or "right_arm"
  std::string name;   // "right_hip.flexion", "legs"
  LayerGeneKind kind = LayerGeneKind::weight;
  // of a weight, otherwise nullptr
  JointWeight* joint = nullptr;
  // of the limbs that a contraction shortens, 0..kLayerGeneMax
  std::vector<double*> contraction{};
  // rad, of a swivel or a final angle, otherwise nullptr; within low..high
  double* angle = nullptr;
  double low = 0.0;
  double high = 0.0;
};

// The upper layer of a body, below it the layer of each goal's arm, then those that have what no
// goal moves, with the genes that are left to them: (1 + goals + idle ones). Fails on a body that
// is not a person's and on goals that are not for arms.
[[nodiscard]] Result<std::vector<Layer>> layers_to_goals(const BodyModel& body,
                                                         std::span<const Goal> goals,
                                                         const LayerChoice& choice = {},
                                                         const CriteriaSettings& criteria = {});
// All members in the layers' order; `layers` are those to the goals. Vectors of another size than
// the layers' are brought to it first: weights of 1, no contraction, freedoms without a gene
// locked, no swivel, and final angles as at the start. The pointers are into `parameters`.
[[nodiscard]] std::vector<LayeredMember> layered_members(std::span<const Layer> layers,
                                                         LayeredParameters& parameters);

// Fails on parameters that no names tell: of other counts than the layers', weights that are not in
// kWeightMin..kWeightMax, contractions that are not in 0..kLayerGeneMax or, of limbs that share
// one, differ, or angles outside their gene's range.
[[nodiscard]] Result<void> check_layered(std::span<const Layer> layers,
                                         const LayeredParameters& parameters);

}  // namespace shigusa
