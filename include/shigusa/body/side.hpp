// SPDX-License-Identifier: MIT
#pragma once

namespace shigusa {

enum class Side { left, right };

}  // namespace shigusa
