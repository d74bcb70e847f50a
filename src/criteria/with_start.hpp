// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>

namespace shigusa {

// The context with its start, by default the first frame of the clip.
[[nodiscard]] CriteriaContext with_start(CriteriaContext context, const Clip& clip);

}  // namespace shigusa
