// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/draw.hpp>
#include <shigusa/generate.hpp>
#include <vector>

namespace shigusa {

// Frames of a strip of a piece of work: its beginning, the ends of its actions and, if these are
// few, their middles and frames between them, where they are furthest apart. Empty for other
// motions.
[[nodiscard]] std::vector<int> work_frames(const Candidate& candidate);

// The actions of a candidate with their names and, of goals, the goals.
[[nodiscard]] std::vector<StripAction> work_actions(const Candidate& candidate);

// A thing that moves.
[[nodiscard]] StripThing moving_thing(const ThingMotion& way);

}  // namespace shigusa
