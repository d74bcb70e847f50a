// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <vector>

#include "plan/motion_input.hpp"

namespace shigusa {

// Values of the whole body's plan as the kernel computes with them: weights, modes, timing and
// supports one after the other, with the memory that a MotionInput looks into.
class HeldInput {
 public:
  // `supports`: how many there are.
  HeldInput(const BodyModel& body, const Parameters& parameters, std::size_t supports);

  [[nodiscard]] MotionInput<double> input() const;

 private:
  std::vector<double> weights_;
  std::vector<double> change_;  // empty without a posture
  Timing<double> timing_{};
  std::vector<double> supports_;
};

}  // namespace shigusa
