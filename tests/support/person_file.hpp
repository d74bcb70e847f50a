// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/formats.hpp>
#include <shigusa/human.hpp>
#include <string>

#include "kinematics/skeleton_motion.hpp"

namespace shigusa::testing_support {

// A BVH file of a person who stands for three frames and bends the right elbow slightly.
inline std::string person_bvh() {
  const PosedBody posed = full_body();
  const BodyModel& body = posed.body;
  Clip clip{.dofs = body.dof_count(), .frames = 3, .angles = {}};
  const auto elbow = static_cast<std::size_t>(body.find_dof("right_elbow.flexion").value());
  for (int f = 0; f < clip.frames; ++f) {
    std::vector<double> angles = posed.home.angles;
    angles[elbow] += 0.2 * f;
    clip.angles.insert(clip.angles.end(), angles.begin(), angles.end());
  }
  return format_bvh(skeleton_motion(body, clip));
}

// A BVH file of a single joint with its End Site, which is no person.
inline std::string one_joint_bvh(
    const std::string& motion = "Frames: 1\nFrame Time: 0.1\n0 0 0\n") {
  return "HIERARCHY\nROOT tail\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
         "End Site\n{\nOFFSET 0 10 0\n}\n}\nMOTION\n" +
         motion;
}

}  // namespace shigusa::testing_support
