// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <span>

#include "plan/plan.hpp"

namespace shigusa {

// The plan that a request's preset has for its goals on a body; `criteria` are those of its layers.
// Fails where a preset of several layers does not know the body, a goal (layers_to_goals) or
// supports.
[[nodiscard]] Result<Plan> plan_of(const BodyModel& body, const Request& request,
                                   const CriteriaSettings& criteria = {});

}  // namespace shigusa
