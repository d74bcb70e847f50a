// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <span>

#include "plan/plan.hpp"

namespace shigusa {

// The plan of a request's preset for its goals on a body; `criteria` are those of its layers. Fails
// if a preset of several layers does not support the body, a goal (layers_to_goals) or supports.
[[nodiscard]] Result<Plan> plan_of(const BodyModel& body, const State& start,
                                   const Request& request, const CriteriaSettings& criteria = {});

}  // namespace shigusa
