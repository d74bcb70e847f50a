// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/core/result.hpp>
#include <shigusa/hierarchy/arm_motion.hpp>
#include <shigusa/hierarchy/reduced_motion.hpp>
#include <shigusa/hierarchy/task.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

// What a layered motion is generated from.
struct LayeredParameters {
  LayerParameters upper;         // trunk and limb lengths
  std::vector<ArmWeights> arms;  // (goals)

  friend bool operator==(const LayeredParameters&, const LayeredParameters&) = default;
};

// One of the numbers that layered parameters consist of, by the name of its gene.
struct LayeredMember {
  std::string layer;  // empty of the upper layer, or "right_arm"
  std::string name;   // "right_hip.flexion", "legs"
  // of a freedom; of a contraction nullptr
  JointWeight* joint = nullptr;
  // of the limbs that a contraction shortens, 0..kLayerGeneMax
  std::vector<double*> contraction{};
};

// The upper layer of a body, and below it the layer of each goal's arm: (1 + goals). Fails on a
// body that is not a person's and on goals that are not for arms.
[[nodiscard]] Result<std::vector<Layer>> layers_to_goals(const BodyModel& body,
                                                         std::span<const Goal> goals,
                                                         const LayeredSettings& settings = {},
                                                         const CriteriaSettings& criteria = {});

// All members in the layers' order; `layers` are those to the goals. Vectors of another size than
// the layers' are brought to it first: weights of 1, no contraction, and freedoms without a gene
// locked. The pointers are into `parameters`.
[[nodiscard]] std::vector<LayeredMember> layered_members(std::span<const Layer> layers,
                                                         LayeredParameters& parameters);

// Fails on parameters that no names tell: of other counts than the layers', weights that are not in
// kWeightMin..kWeightMax, contractions that are not in 0..kLayerGeneMax or, of limbs that share
// one, differ.
[[nodiscard]] Result<void> check_layered(std::span<const Layer> layers,
                                         const LayeredParameters& parameters);

}  // namespace shigusa
