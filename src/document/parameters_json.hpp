// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <string>

#include "formats/json_reader.hpp"

namespace shigusa {

// A candidate's values as results hold them: each stands under what it is of, "weights" and
// "locked", "contractions" or "posture", those of an arm's own layer below "arms" and its name.
[[nodiscard]] Json parameters_to_json(const ParameterList& list, const Parameters& values);

// The values of one stored candidate; every number of the plan must be there, but for a posture,
// of which what is missing is 0.
[[nodiscard]] Result<Parameters> read_parameters(const ParameterList& list, const Json& candidate,
                                                 const std::string& place);

}  // namespace shigusa
