// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>
#include <vector>

namespace shigusa {

// The points that stay on their paths between a clip's frames.
struct Held {
  std::vector<Foot> feet;           // planted ones: their soles, and how these are turned
  std::vector<Effector> effectors;  // the points of goals
};

// The clip at `rate` frames a second as resampled(clip, rate) has it, with what is held on splines
// of its own through where it is in the clip's frames: splines of angles alone move a second foot
// by millimetres where angles change fast. Steps of IK with equal weights take that back; freedoms
// that do not move in the clip stay.
[[nodiscard]] Clip resampled(const BodyModel& body, const Clip& clip, double rate,
                             const Held& held);

}  // namespace shigusa
