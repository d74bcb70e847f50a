// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>

#include "kinematics/rig.hpp"

namespace shigusa {

// Which frames of a record are fitted: those that are looked at, and as far as there are any so
// many on either side of them.
struct FitFrames {
  int first = 0;
  int last = 0;  // included; 0 ≤ first ≤ last < frames of the record
  int around = 0;
};

// Frames of a motion of the rig's skeleton, in the units and axes of the rig's placement: in each,
// the angles whose joints stand nearest to the recorded ones,
//
//   min over q of  Σ_bones |p_bone(q) - p_recorded|² + l² |turn from R_link(q) to R_recorded|²,
//
// by Levenberg's damped Gauss-Newton steps from the frame beside it, the first from the body's
// start. Of bones that are one link the first tells its turn; l is 3 cm, so that turns decide what
// joints leave open (a forearm's rotation, a straight arm's) and little else. A motion of this very
// body comes out exactly. Limits are not asked: people pass them.
//
// The body's base stays where it is. Where the recorded one moves, the rest follows as it can.
// Source: D. W. Marquardt, J. SIAM 11 (1963) 431-441.
[[nodiscard]] ClipFit fit_clip(const BodyModel& body, const Rig& rig,
                               const SkeletonMotion& recorded, const FitFrames& frames);

}  // namespace shigusa
