// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/generate.hpp>
#include <vector>

namespace shigusa {

// The candidate with its motion at a rate (Hz): postures, effectors and things as in motion_at;
// torques and the centre of mass lie on lines between the motion's own frames. Fails as
// clip_at_rate does.
[[nodiscard]] Result<Candidate> sampled(const CharacterSpec& character, const Task& task,
                                        const Candidate& candidate, double rate);

// Converts a point (m), or a direction, from shigusa's world to a robot's: x ahead, y to the left,
// z up.
[[nodiscard]] inline Vec3d in_robot_world(const Vec3d& point) {
  return {point.z, point.x, point.y};
}

// (frames) placements of a robot's root link, in the robot's world.
[[nodiscard]] std::vector<Transformd> root_places(const BodyModel& body, const RobotFrame& robot,
                                                  const Clip& clip);

// (frames) a joint's part of a table of all degrees of freedom, (frames × dofs), in the file's
// sign. Precondition: the joint is one of them.
[[nodiscard]] std::vector<double> of_joint(const RobotJoint& joint, const std::vector<double>& all,
                                           int dofs);

}  // namespace shigusa
