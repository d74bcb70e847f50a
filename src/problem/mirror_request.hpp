// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <span>
#include <string>
#include <string_view>

#include "plan/plan.hpp"

namespace shigusa {

// A point of the world mirrored in the body's sagittal plane.
[[nodiscard]] inline Vec3d across(const Vec3d& p) { return {-p.x, p.y, p.z}; }

// Mirrors a request in the body's sagittal plane, x = 0.
void mirror_request(Request& request);

// The values of a motion's mirror image: each value goes to the parameter of the other side, and a
// turn of the trunk changes its sign.
[[nodiscard]] Parameters mirrored_values(const ParameterList& from, const ParameterList& to,
                                         const Parameters& values);

}  // namespace shigusa
