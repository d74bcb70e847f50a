// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

// The foot that is the body's fixed base; null if there is none.
[[nodiscard]] const Foot* base_foot(const BodyModel& body);

// Nodes of the base foot. Goals may be given for them, which are met by a body that stands on
// another foot. Empty for robots, whose standing foot is fixed.
[[nodiscard]] std::vector<const BodyNode*> base_nodes(const BodyModel& body);
// Names of all effectors that goals may be given for, those of the base last.
[[nodiscard]] std::vector<std::string> goal_names(const BodyModel& body);

// Body with these of its feet on the floor. Other feet bear no load and move freely. Unknown names
// are ignored.
[[nodiscard]] BodyModel standing_on(const BodyModel& body, std::span<const std::string> feet);

}  // namespace shigusa
