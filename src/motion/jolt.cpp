// SPDX-License-Identifier: MIT
#include "motion/jolt.hpp"

namespace shigusa {
bool jolts(const Clip& clip) {
  for (int f = 2; f < clip.frames; ++f) {
    for (int d = 0; d < clip.dofs; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double change = clip.frame(f)[k] - 2.0 * clip.frame(f - 1)[k] + clip.frame(f - 2)[k];
      if (abs(change) > kJolt) return true;
    }
  }
  return false;
}

}  // namespace shigusa
