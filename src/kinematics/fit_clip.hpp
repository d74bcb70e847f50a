// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>

#include "kinematics/rig.hpp"

namespace shigusa {

// The fitted frames of a record: a range, with up to `around` more frames on either side where
// there are any.
struct FitFrames {
  int first = 0;
  int last = 0;  // included; 0 ≤ first ≤ last < frames of the record
  int around = 0;
};

// Fits a body to frames of a motion of the rig's skeleton, in the units and axes of the rig's
// placement: the angles with the joints nearest to the recorded ones,
//
//   min over q of  Σ_bones |p_bone(q) - p_recorded|² + l² |turn from R_link(q) to R_recorded|²,
//
// by Levenberg's damped Gauss-Newton steps from the neighbouring frame, for the first frame from
// the body's home. Among bones on one link the first determines its turn; l is 3 cm, so that
// turns decide only the dofs left open by the joints (a forearm's rotation, a straight arm's). A
// motion of the body itself is recovered exactly. Limits are ignored: people exceed them.
//
// The body's base is fixed. If the recorded one moves, the other joints follow as far as possible.
// Source: D. W. Marquardt, J. SIAM 11 (1963) 431-441.
[[nodiscard]] ClipFit fit_clip(const PosedBody& body, const Rig& rig,
                               const SkeletonMotion& recorded, const FitFrames& frames);

}  // namespace shigusa
