// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/run.hpp>

namespace shigusa {

// PreconditionError where this machine cannot run the set.
void require_usable(SimdSet set);

}  // namespace shigusa
