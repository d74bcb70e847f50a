// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <shigusa/request.hpp>

#include "kinematics/rig.hpp"

namespace shigusa {

// Finger movement of a task's candidate: hands with goals open on the way and close at its end;
// hands that hold a thing close about it, open to let it go and are as at the start again.
[[nodiscard]] HandPlay hand_play(const Task& task, const Candidate& candidate);

}  // namespace shigusa
