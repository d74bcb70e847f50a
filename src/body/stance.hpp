// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_model.hpp>
#include <span>
#include <string>

namespace shigusa {

// The foot that is the body's base, which cannot move; nothing where no foot is.
[[nodiscard]] const Foot* base_foot(const BodyModel& body);

// The body with these of its feet on the floor. Others bear nothing and are free to move. Names
// that are no feet of the body are as good as none.
[[nodiscard]] BodyModel standing_on(const BodyModel& body, std::span<const std::string> feet);

}  // namespace shigusa
