// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>
#include <vector>

#include "dynamics/centre_of_mass.hpp"
#include "support/bodies.hpp"

// Motions for tests of code that reads them.
namespace shigusa::testing_support {

// A motion through these postures, (frames) of (dofs, rad), with torques of 0 and the body's own
// centre of mass.
inline Motion motion_through(const BodyModel& body,
                             const std::vector<std::vector<double>>& postures) {
  Motion motion;
  motion.clip.dofs = body.dof_count();
  motion.clip.frames = static_cast<int>(postures.size());
  for (const std::vector<double>& q : postures) {
    motion.clip.angles.insert(motion.clip.angles.end(), q.begin(), q.end());
    motion.torques.resize(motion.clip.angles.size(), 0.0);
    motion.centre_of_mass.push_back(centre_of_mass(body, placed(body, q)));
  }
  return motion;
}

}  // namespace shigusa::testing_support
