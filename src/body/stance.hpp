// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

// The foot that is the body's base, which cannot move; nothing where no foot is.
[[nodiscard]] const Foot* base_foot(const BodyModel& body);

// The nodes of the foot that is the body's base: goals can be given for them, by a body that stands
// on another foot. None of robots, which stand as their files have them.
[[nodiscard]] std::vector<const BodyNode*> base_nodes(const BodyModel& body);
// The names of all effectors that goals can be given for, those of the base last.
[[nodiscard]] std::vector<std::string> goal_names(const BodyModel& body);

// The body with these of its feet on the floor. Others bear nothing and are free to move. Names
// that are no feet of the body are as good as none.
[[nodiscard]] BodyModel standing_on(const BodyModel& body, std::span<const std::string> feet);

}  // namespace shigusa
