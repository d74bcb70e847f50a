// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>
#include <span>

namespace shigusa {

// A point of a link that stays on its path between a clip's frames.
struct HeldPoint {
  int link = 0;
  Vec3d point{};       // m, link frame
  bool turns = false;  // with its orientation: planted soles, hands on a thing
  bool exact = false;  // planted soles
};

// The clip at `rate` frames a second as by resampled(clip, rate), with the held points on splines
// through their positions in the clip's frames: splines of angles alone move a second foot by
// millimetres where angles change fast. IK steps with equal weights correct that; dofs that do not
// move in the clip stay.
[[nodiscard]] Clip resampled(const BodyModel& body, const Clip& clip, double rate,
                             std::span<const HeldPoint> held);

}  // namespace shigusa
