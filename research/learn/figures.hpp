// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/motion.hpp>

// Figures that characterise people's motions, computed from one motion.
namespace shigusa::bench {

// Reference stature for lengths, which makes figures of short and tall people comparable (m).
inline constexpr double kUsualStature = 1.741;

// Lengths are scaled to a body of kUsualStature; changes are from the first frame to the last.
struct Figures {
  double trunk = 0.0;         // deg, at the end: from hips to shoulders, against the vertical
  double knee = 0.0;          // deg, at the end, mean of both
  double knee_change = 0.0;   // deg
  double shank = 0.0;         // deg, forwards, at the end
  double drop = 0.0;          // m, descent of the hips from start to end
  double back = 0.0;          // m, backward travel of the hips
  double travel = 0.0;        // m, of the hips
  double mass = 0.0;          // share of the foot's length, forward travel of the centre of mass
  double bow = 0.0;           // of the distance: largest forward deviation of the wrist from its
                              // line
  double peak = 0.0;          // of the time: moment of the wrist's greatest speed
  double shoulder = 0.0;      // share of the shoulder in the wrist's forward travel
  double index = 0.0;         // change of the knee over those of ankle, hip and back
  double style = 0.0;         // 100 stoop, 0 squat; 50 if the shoulders do not move
  double first = 0.0;         // of the variance of six segments' angles, the first component's
  double lumbar = 0.0;        // deg, change of the back's bend
  double hip = 0.0;           // deg, change of the hips' bend
  double lumbar_share = 0.0;  // of both
  double lumbar_lead = 0.0;   // back over hips at a third of the time, less that at the end
  double head = 0.0;          // m, above the hips at the end
  double free_elbow = 0.0;    // deg, of the other arm
  double clavicle = 0.0;      // of the arm's elevation, the clavicle's
  double jolt = 0.0;  // greatest change between frames, in units of 3 cm or 30 % of strength
  double hard = 0.0;  // 0 possible, 1 strains, 2 impossible, 3 not reached
};

// For a motion of the body human that moves that side's hand. Without torques the centre of mass
// and jolts are missing.
[[nodiscard]] Figures figures_of(const BodyModel& body, const Motion& motion, Side side);

}  // namespace shigusa::bench
