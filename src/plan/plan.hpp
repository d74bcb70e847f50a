// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
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

// The upper layer of a body, below it the layer of each goal's arm, then the layers of limbs that
// no goal moves, with the parameters of those limbs alone. Fails on a body that is not a person's
// and on goals that are not for arms.
[[nodiscard]] Result<Plan> layers_to_goals(const BodyModel& body, std::span<const Goal> goals,
                                           const LayerChoice& choice = {},
                                           const CriteriaSettings& criteria = {});

// All of a plan's parameters.
[[nodiscard]] ParameterList parameter_list(std::span<const Layer> plan);

}  // namespace shigusa
