// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/goal.hpp>
#include <shigusa/result.hpp>
#include <span>
#include <string>
#include <vector>

#include "plan/layer.hpp"

namespace shigusa {

// A plan is a list of layers: what is searched first, and what below it. The plan of one layer
// moves all freedoms of the whole body at once; that layer has no reduced body.
using Plan = std::vector<Layer>;

// The plan of one layer. Its parameters are the weights of all freedoms, the posture modes, the
// timing and what resting hands press with.
[[nodiscard]] Plan whole_body_plan(const BodyModel& body, std::span<const Support> supports = {});
// Whether a plan has that one layer.
[[nodiscard]] bool moves_whole_body(std::span<const Layer> plan);

// The upper layer of a body, below it the layer of each goal's arm, then the layers of limbs that
// no goal moves, with the parameters of those limbs alone. Fails on a body that is not a person's
// and on goals that are not for arms.
[[nodiscard]] Result<Plan> layers_to_goals(const BodyModel& body, std::span<const Goal> goals,
                                           const LayerChoice& choice = {},
                                           const CriteriaSettings& criteria = {});

// One of a plan's parameters, with its place in the values that a motion is generated from.
struct Parameter {
  const Layer* layer = nullptr;
  const ParameterInfo* info = nullptr;
  std::vector<double*> values{};  // of limbs that share a contraction several, all the same
  bool* locked = nullptr;         // of a weight
  bool below = false;             // of a layer below the first

  [[nodiscard]] double value() const { return *values.front(); }
  void set(double value) const {
    for (double* place : values) *place = value;
  }
  // "right_hip.flexion", "right_arm.right_elbow.flexion" of the layer below, "squat".
  [[nodiscard]] std::string subject() const;
  // As people write and read it: "right_hip.flexion.weight", "legs.contraction", "squat_deg". An
  // angle takes a unit, "_deg" or "_rad".
  [[nodiscard]] std::string spelled(std::string_view unit = "_deg") const;
};

// The values that a plan begins with: weights of 1, no contraction, freedoms without a weight of
// their own locked, no posture, no swivel, and final angles as at the start.
[[nodiscard]] Parameters start_values(std::span<const Layer> plan);
// Adds a posture of 0 to values that have none, so that all numbers have a place.
void give_posture(std::span<const Layer> plan, Parameters& values);

// All parameters that the values have, in the plan's order; those of a posture only where the
// values have one. The values have the plan's counts; plan and values outlive it.
[[nodiscard]] std::vector<Parameter> parameters_of(std::span<const Layer> plan, Parameters& values);

// Fails on values that the plan cannot name: of other counts than the plan's, outside a parameter's
// range, contractions that differ of limbs that share one, and freedoms that are free and have no
// weight in the plan.
[[nodiscard]] Result<void> check_parameters(std::span<const Layer> plan, const Parameters& values);

// Values of a body of which none is fixed.
[[nodiscard]] FixedParameters no_fixed_parameters(const BodyModel& body,
                                                  std::span<const Support> supports = {});

}  // namespace shigusa
