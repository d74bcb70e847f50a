// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
#include <span>
#include <string>
#include <vector>

#include "plan/layer.hpp"

namespace shigusa {

// A plan is a list of layers, from the first searched to the last. The plan of one layer moves all
// dofs of the whole body at once; that layer has no reduced body.
using Plan = std::vector<Layer>;

// The plan of one layer. Its parameters are the weights of all dofs, the posture modes, the timing
// and the loads of resting hands.
[[nodiscard]] Plan whole_body_plan(const BodyModel& body, std::span<const Support> supports = {});

// The upper layer of a body, then the layer of each goal's arm, then the layers of idle limbs, with
// the parameters of those limbs alone. Fails for a body that is not a person's and for goals that
// are not for arms.
[[nodiscard]] Result<Plan> layers_to_goals(const BodyModel& body, const State& start,
                                           std::span<const Goal> goals,
                                           const LayerChoice& choice = {},
                                           const CriteriaSettings& criteria = {});

// All parameters of a plan.
[[nodiscard]] ParameterList parameter_list(std::span<const Layer> plan);

}  // namespace shigusa
