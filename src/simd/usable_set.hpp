// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/run.hpp>

namespace shigusa {

// Throws PreconditionError if this machine cannot run the set.
void require_usable(SimdSet set);

}  // namespace shigusa
