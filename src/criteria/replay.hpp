// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria/motion_frame.hpp>
#include <shigusa/motion/motion.hpp>

namespace shigusa {

// Shows a stored motion to a criterion, frame by frame.
template <class Criterion>
[[nodiscard]] double replay(const Motion& motion, Criterion criterion) {
  const auto dofs = static_cast<std::size_t>(motion.clip.dofs);
  for (int f = 0; f < motion.clip.frames; ++f) {
    const auto k = static_cast<std::size_t>(f);
    criterion.add(MotionFrame<double>{
        motion.clip.frame(f), std::span<const double>(motion.torques).subspan(k * dofs, dofs),
        motion.centre_of_mass[k]});
  }
  return criterion.penalty();
}

}  // namespace shigusa
