// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "mjcf_values.hpp"

namespace shigusa {

// Key frames of a model whose size matches its joints, in terms of the robot's joints; an unnamed
// one is named by its index. `joint_of`: the robot's joint of an element, for a ball the first of
// three.
[[nodiscard]] std::vector<Robot::Keyframe> read_keyframes(
    MjcfFiles& files, const MjcfValues& values,
    const std::map<const XmlElement*, std::size_t>& joint_of, const Robot& robot);

}  // namespace shigusa
