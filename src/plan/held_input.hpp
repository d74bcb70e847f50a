// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/parameters.hpp>
#include <span>
#include <vector>

#include "plan/motion_input.hpp"

namespace shigusa {

// 1 / weight of each of the paper's genes, 0 where locked, in single precision: (motions × dofs),
// genome after genome.
[[nodiscard]] std::vector<float> inverse_weights_of_genes(std::span<const std::uint16_t> genes);

// 1 / weight of each dof, 0 where locked: (dofs), for values of the whole body.
[[nodiscard]] std::vector<double> inverse_weights(const BodyModel& body,
                                                  const Parameters& parameters);

// The change of posture of the modes' values: (dofs) rad. PreconditionError unless there are as
// many values as the body has modes.
[[nodiscard]] std::vector<double> posture_change(const BodyModel& body,
                                                 std::span<const double> modes);

// Values of the whole body's plan in the form used by the kernel: weights, modes, timing and
// supports in sequence, with the memory to which a MotionInput refers.
class HeldInput {
 public:
  // `supports`: their number.
  HeldInput(const BodyModel& body, const Parameters& parameters, std::size_t supports);

  [[nodiscard]] MotionInput<double> input() const;

 private:
  std::vector<double> weights_;
  std::vector<double> change_;  // empty without a posture
  Timing<double> timing_{};
  std::vector<double> supports_;
};

}  // namespace shigusa
