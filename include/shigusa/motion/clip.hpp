// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace shigusa {

// A body's motion: joint angles at equally spaced times.
struct Clip {
  int dofs = 0;
  int frames = 0;
  double frame_time = 1.0 / 60.0;  // s
  std::vector<double> angles;      // (frames × dofs) rad, dof order of BodyModel

  [[nodiscard]] std::span<const double> frame(int index) const {
    return std::span<const double>(angles).subspan(
        static_cast<std::size_t>(index) * static_cast<std::size_t>(dofs),
        static_cast<std::size_t>(dofs));
  }
  [[nodiscard]] double duration() const { return frames > 1 ? (frames - 1) * frame_time : 0.0; }
};

}  // namespace shigusa
