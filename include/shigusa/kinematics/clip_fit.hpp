// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion/clip.hpp>
#include <string>
#include <vector>

namespace shigusa {

// How far a recorded foot goes from where it is in the first frame.
struct FootTravel {
  std::string foot;     // "right_foot"
  int node = -1;        // of the recorded skeleton
  bool base = false;    // the body stands on it, so that it cannot follow
  double travel = 0.0;  // m, of its joint, the most at any frame
  double turn = 0.0;    // rad, the same
};

// A recorded motion as a body's angles.
struct ClipFit {
  Clip clip;       // with the frames around
  int before = 0;  // how many of these come before the first that is looked at
  // m, between recorded joints and the body's, over joints and frames; those of the standing foot
  // apart
  double mean_distance = 0.0;
  double worst_distance = 0.0;   // m, the largest of the same
  std::string worst_joint;       // humanoid bone that it is of
  int worst_frame = 0;           // of the record, when it is
  std::vector<FootTravel> feet;  // how far the recorded feet go
};

}  // namespace shigusa
