// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>
#include <vector>

namespace shigusa {

// Points that stay on their paths between a clip's frames.
struct Held {
  std::vector<Foot> feet;           // planted feet: position and orientation of their soles
  std::vector<Effector> effectors;  // the points of goals
};

// The clip at `rate` frames a second as by resampled(clip, rate), with the held points on splines
// through their positions in the clip's frames: splines of angles alone move a second foot by
// millimetres where angles change fast. IK steps with equal weights correct that; dofs that do not
// move in the clip stay.
[[nodiscard]] Clip resampled(const BodyModel& body, const Clip& clip, double rate,
                             const Held& held);

}  // namespace shigusa
