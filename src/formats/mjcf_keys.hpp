// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "mjcf_values.hpp"

namespace shigusa {

// The key frames of a model that have as many numbers as its joints take, by the robot's joints;
// one without a name is called by its index. `joint_of`: the robot's joint that an element is, of a
// ball the first of three.
[[nodiscard]] std::vector<Robot::Keyframe> read_keyframes(
    MjcfFiles& files, const MjcfValues& values,
    const std::map<const XmlElement*, std::size_t>& joint_of, const Robot& robot);

}  // namespace shigusa
