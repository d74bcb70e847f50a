// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <vector>

#include "plan/motion_input.hpp"

namespace shigusa {

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
