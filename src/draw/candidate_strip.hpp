// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/draw.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/request.hpp>
#include <vector>

namespace shigusa {

// How a task's motions are drawn: as the body faces, with the goals' limbs in the accent colour.
[[nodiscard]] StripSettings strip_settings(const Task& task);

// The things in the way and the seat, if there is one.
[[nodiscard]] std::vector<StripThing> things_around(const Task& task);

// A candidate's strip: its figure, things around it, goals, centre of mass and the way of the first
// goal's effector.
[[nodiscard]] MotionStrip candidate_strip(const Task& task, const Candidate& candidate);

}  // namespace shigusa
