// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <span>
#include <string>
#include <string_view>

#include "plan/plan.hpp"

namespace shigusa {

// A point of the world on the other side of the body's middle.
[[nodiscard]] inline Vec3d across(const Vec3d& p) { return {-p.x, p.y, p.z}; }

// Takes a request to the other side of the body's middle, x = 0.
void mirror_request(Request& request);

// The values of a motion's mirror image: each goes to the parameter of the other side, and a turn
// of the trunk changes its sign.
[[nodiscard]] Parameters mirrored_values(const ParameterList& from, const ParameterList& to,
                                         const Parameters& values);

}  // namespace shigusa
