// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "paper/layered_rollout.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// Plays and records motions of a hierarchy, one at a time (see LayeredRollout). Owns scratch
// memory: one per thread. The problem outlives it.
class LayeredPlayer {
 public:
  explicit LayeredPlayer(const LayeredProblem& problem);
  LayeredPlayer(LayeredPlayer&&) noexcept;
  ~LayeredPlayer();

  // Plays the upper layer's motion.
  void run_upper(const LayeredValues& parameters, ReducedClip<double>& clip);
  // The hand's path of each goal in an upper motion.
  [[nodiscard]] std::vector<HandPath> hand_paths(const ReducedClip<double>& clip);
  // Excess of the legs' joints over their limits for the pelvis of an upper motion (rad, the
  // largest over all frames; rule R4), and whether all legs can have the required lengths.
  struct PelvisCheck {
    double excess = 0.0;
    bool in_reach = true;
  };
  [[nodiscard]] PelvisCheck check_pelvis(const ReducedClip<double>& clip);
  // The best of a few swivels for each arm moved by swivel, on the paths of an upper motion.
  [[nodiscard]] std::vector<double> find_swivels(const ReducedClip<double>& clip);
  // The whole body's motion for an upper motion and the parameters of the layers below; those of
  // the upper layer are the clip's. A hand leaves its path if its arm cannot follow it with its
  // weights (mostly for locked joints).
  [[nodiscard]] RolledOut expand(const ReducedClip<double>& clip, const LayeredValues& parameters);
  // Expands in the same way, but gives an arm that cannot follow its path equal weights for all
  // dofs.
  [[nodiscard]] RolledOut expand_freeing(const ReducedClip<double>& clip,
                                         LayeredValues& parameters);

  [[nodiscard]] const LayeredSetup& setup() const { return *setup_; }

 private:
  [[nodiscard]] RolledOut played(const ReducedClip<double>& clip, const LayeredValues& parameters,
                                 bool freeing);

  std::unique_ptr<const LayeredSetup> setup_;
  std::unique_ptr<LayeredRollout<double>> rollout_;
  std::vector<PelvisRange> ranges_;  // (legs)
};

// The inverse weights of an upper motion's dofs, 0 where locked.
[[nodiscard]] std::vector<double> upper_weights(const LayeredValues& parameters);

}  // namespace shigusa
