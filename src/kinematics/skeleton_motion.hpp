// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>

namespace shigusa {

// The body's own skeleton of BodyNodes, at rest where all angles are 0; metres, shigusa's world.
[[nodiscard]] Skeleton body_skeleton(const BodyModel& body);

// A clip of the body as a motion of body_skeleton(body): what is written to files and drawn.
[[nodiscard]] SkeletonMotion skeleton_motion(const BodyModel& body, const Clip& clip);

}  // namespace shigusa
