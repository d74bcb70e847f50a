// SPDX-License-Identifier: MIT
#pragma once

#include "layers/arm_feedback.hpp"
#include "layers/arm_swivel.hpp"
#include "layers/clip_dynamics.hpp"

namespace shigusa {

// Beside the layer's criteria a swivel that leaves the joints' limits or jolts costs this: it is
// taken only where all do …
inline constexpr double kSwivelOver = 1.0;
// … and one that leads the arm into the body costs P = min(1, depth / kCollisionFull) times this.
inline constexpr double kSwivelCollisionWeight = 2.0;

// Chooses the swivel of one arm on a hand's path. Holds its scratch memory: make one per thread.
// Arm and layer outlive it.
class SwivelSearch {
 public:
  SwivelSearch(const BodyModel& arm, const BodyLimb& limb, const Layer& layer);

  // The best of a few, for the search of the layer above.
  [[nodiscard]] double coarse(const ArmFeedback& feedback);
  // The best of a finer grid, then of the golden section about it.
  [[nodiscard]] double fine(const ArmFeedback& feedback);

 private:
  struct Best {
    double swivel = 0.0;  // rad
    double score = 0.0;
  };
  [[nodiscard]] Best best_of_grid(const ArmFeedback& feedback, int points);
  [[nodiscard]] double score(const ArmFeedback& feedback, double swivel);

  const BodyModel* arm_;
  const Layer* layer_;
  SwivelArm moved_;
  ClipDynamics dynamics_;
  Kinematics<double> placed_;
};

}  // namespace shigusa
