// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/task.hpp>
#include <span>

#include "layers/plan.hpp"

namespace shigusa {

// The plan that a preset has for a body's goals; `criteria` are those of its layers. Fails where a
// preset of several layers does not know the body or a goal (layers_to_goals).
[[nodiscard]] Result<Plan> plan_of(const BodyModel& body, std::span<const Goal> goals,
                                   Preset preset, LayerReading reading,
                                   const CriteriaSettings& criteria = {});
[[nodiscard]] Result<Plan> plan_of(const Task& task);

}  // namespace shigusa
