// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/draw.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/request.hpp>
#include <vector>

namespace shigusa {

// Strip settings for a task's motions: seen relative to the body's facing direction, with the
// limbs in the accent colour that go to goals, or that act in a piece of work.
[[nodiscard]] StripSettings strip_settings(const Task& task, const Candidate& candidate);

// Obstacles, and the seat if there is one.
[[nodiscard]] std::vector<StripThing> things_around(const Task& task);

// Strip of a candidate: its figure, the things around it, goals, centre of mass and the path of the
// first goal's effector. That of a piece of work has the names of its actions, of which it shows
// the ends, and the goals of each.
[[nodiscard]] MotionStrip candidate_strip(const Task& task, const Candidate& candidate);

}  // namespace shigusa
