// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <shigusa/parameters.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Parameters of one motion in the form used by the kernel; S is double, or a pack whose lanes are
// separate motions.
template <class S>
struct MotionInput {
  std::span<const S> inverse_weights;  // (dofs) see weighted_ik_step
  // (dofs, rad) change of the null space from the start posture to the end, or empty
  std::span<const S> posture{};
  Timing<S> timing{};
  // (supports) share of the body's weight borne by each resting hand; below 0 the hand is free.
  // Empty: all touch without load.
  std::span<const S> supports{};

  // weights alone
  MotionInput(std::span<const S> weights) : inverse_weights(weights) {}     // NOLINT
  MotionInput(const std::vector<S>& weights) : inverse_weights(weights) {}  // NOLINT
  MotionInput(std::span<const S> weights, std::span<const S> change, const Timing<S>& when)
      : inverse_weights(weights), posture(change), timing(when) {}
};

// Parameters of many motions, in sequence, in single precision.
struct MotionInputs {
  std::span<const float> inverse_weights;  // (motions × dofs)
  std::span<const float> posture{};        // (motions × dofs) or empty
  // (motions × kTimings), in the order of kTimingNumbers; empty if posture is
  std::span<const float> timing{};
  std::span<const float> supports{};  // (motions × supports) or empty, see MotionInput

  MotionInputs(std::span<const float> weights) : inverse_weights(weights) {}     // NOLINT
  MotionInputs(const std::vector<float>& weights) : inverse_weights(weights) {}  // NOLINT
  MotionInputs(std::span<const float> weights, std::span<const float> change,
               std::span<const float> times)
      : inverse_weights(weights), posture(change), timing(times) {}

  // The rows of `count` motions from `first` on, for a body with this number of dofs.
  [[nodiscard]] MotionInputs part(std::size_t first, std::size_t count, std::size_t dofs) const {
    const auto rows = [&](std::span<const float> all, std::size_t columns) {
      return all.empty() ? all : all.subspan(first * columns, count * columns);
    };
    MotionInputs some{rows(inverse_weights, dofs), rows(posture, dofs), rows(timing, kTimings)};
    if (!supports.empty()) {
      some.supports = rows(supports, supports.size() * dofs / inverse_weights.size());
    }
    return some;
  }
};

}  // namespace shigusa
