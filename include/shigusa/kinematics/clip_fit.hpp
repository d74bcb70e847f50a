// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/body/skeleton.hpp>
#include <shigusa/kinematics/rig.hpp>
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

// Which frames of a record are fitted: those that are looked at, and as far as there are any so
// many on either side of them.
struct FitFrames {
  int first = 0;
  int last = 0;  // included; 0 ≤ first ≤ last < frames of the record
  int around = 0;
};

// A recorded motion as a body's angles.
struct ClipFit {
  Clip clip;       // with the frames around
  int before = 0;  // how many of these come before the first that is looked at
  // between recorded joints and the body's, those of the standing foot apart:
  double mean_distance = 0.0;   // m, over joints and frames
  double worst_distance = 0.0;  // m
  std::string worst_joint;      // humanoid bone
  int worst_frame = 0;          // of the record
  std::vector<FootTravel> feet;
};

// Frames of a motion of the rig's skeleton, in the units and axes of the rig's placement: in each,
// the angles whose joints stand nearest to the recorded ones,
//
//   min over q of  Σ_bones |p_bone(q) - p_recorded|² + l² |turn from R_link(q) to R_recorded|²,
//
// by Levenberg's damped Gauss-Newton steps from the frame beside it, the first from the body's
// start. Of bones that are one link the first tells its turn; l is 3 cm, so that turns decide what
// joints leave open (a forearm's rotation, a straight arm's) and little else. What a motion of this
// very body was written from comes out exactly. Limits are not asked: people pass them.
//
// The body's base stays where it is. Where the recorded one moves, the rest follows as it can.
// Source: D. W. Marquardt, J. SIAM 11 (1963) 431-441.
[[nodiscard]] ClipFit fit_clip(const BodyModel& body, const Rig& rig,
                               const SkeletonMotion& recorded, const FitFrames& frames);

}  // namespace shigusa
