// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

namespace shigusa {

// Whether some joint's step changes from one frame to the next by more than a smooth motion's does.
[[nodiscard]] bool jolts(const Clip& clip);

}  // namespace shigusa
