// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <string>

#include "formats/json_reader.hpp"

namespace shigusa {

// A candidate's values as results hold them: each by its name, "squat_rad", those of a posture only
// where there is one; then the names of those that are "locked", and whether the motion is
// "reflected".
[[nodiscard]] Json parameters_to_json(const ParameterList& list, const Parameters& values);

// The values of one stored candidate; every number of the list must be there, but for a posture,
// of which what is missing is 0.
[[nodiscard]] Result<Parameters> read_parameters(const ParameterList& list, const Json& candidate,
                                                 const std::string& place);

}  // namespace shigusa
