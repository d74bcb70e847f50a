// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>

#include "mjcf_values.hpp"

namespace shigusa {

// How much the actuators of a model can do about the axes of its joints.
class MjcfActuators {
 public:
  MjcfActuators(MjcfFiles& files, MjcfValues& values);

  // N·m, or N: what the actuators of a joint come to about its axis of that index, no more than
  // actuatorfrcrange allows; 0 where there is no limit, or nothing that drives it.
  [[nodiscard]] double effort(const std::string& joint, const MjcfPart& part, std::size_t axis);

 private:
  void read(const MjcfPart& part);

  MjcfValues& values_;
  std::map<std::string, std::array<double, 3>> sums_;  // by joint; infinite: no limit
};

}  // namespace shigusa
