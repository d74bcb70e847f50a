// SPDX-License-Identifier: MIT
#pragma once

namespace shigusa {

// A side of the body, as the person has it.
enum class Side { left, right };

}  // namespace shigusa
