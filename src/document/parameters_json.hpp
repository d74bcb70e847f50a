// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <string>

#include "formats/json_reader.hpp"

namespace shigusa {

// A candidate's values in results: each value by its name, such as "squat_rad" (posture values only
// if there is a posture), then the names of the "locked" values, and whether the motion is
// "reflected".
[[nodiscard]] Json parameters_to_json(const ParameterList& list, const Parameters& values);

// Values of one stored candidate. Every number of the list is required, except that missing values
// of a posture are 0.
[[nodiscard]] Result<Parameters> read_parameters(const ParameterList& list, const Json& candidate,
                                                 const std::string& place);

}  // namespace shigusa
