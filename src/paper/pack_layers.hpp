// SPDX-License-Identifier: MIT
#pragma once

#include "paper/idle_cost.hpp"
#include "paper/layered_lanes.hpp"
#include "paper/layered_rollout.hpp"
#include "simd/pack.hpp"

namespace shigusa {

// Layered motions for the lanes of one Pack<float, N>. Included only by the source files compiled
// for a SIMD set, with the same restrictions as PackScorer.
template <int N>
class PackLayers final : public LayeredLanes {
 public:
  using S = Pack<float, N>;

  PackLayers(const LayeredSetup& setup, const CriteriaSettings& criteria)
      : setup_(&setup),
        rollout_(setup),
        criteria_(setup.body(), setup.problem->reach.context, criteria),
        excess_(setup.body()),
        idle_(setup),
        inverse_weights_(setup.upper.dofs().size()),
        contractions_(setup.upper.body->limbs.size()),
        finals_(setup.finals.size()),
        worst_(worst_score(criteria)) {
    for (const auto& arm : setup.arms) {
      if (arm.by_swivel) {
        swivels_.push_back(S(0));
      } else {
        arms_.resize(arms_.size() + kArmDofs);
      }
    }
  }

  void run_upper(const LayeredInputs& inputs, std::span<Vec3d> hands) override {
    const std::size_t goals = setup_->arms.size();
    const int motions = static_cast<int>(hands.size() / goals);
    spread(inputs.inverse_weights, motions, inverse_weights_);
    spread(inputs.contractions, motions, contractions_);
    rollout_.run_upper({inverse_weights_, contractions_});
    for (std::size_t k = 0; k < hands.size(); ++k) {
      const Vec3<S>& end = rollout_.paths()[k % goals].back();
      const int lane = static_cast<int>(k / goals);
      hands[k] = {end.x[lane], end.y[lane], end.z[lane]};
    }
  }

  void expand(const LayeredInputs& inputs, std::span<double> scores,
              std::span<float> final_angles) override {
    const int motions = static_cast<int>(scores.size());
    const ReducedClip<S>& upper = rollout_.clip();
    const ReachProblem& reach = setup_->problem->reach;
    const auto leads = (upper.path_error <= S(reach.tolerance.path)) &
                       (upper.foot_error <= S(kReachTolerance)) & rollout_.in_reach();
    const S missed = min(upper.path_error + upper.foot_error, S(1));
    for (int lane = 0; lane < motions; ++lane) {
      scores[index(lane)] = worst_ + static_cast<double>(missed[lane]);
    }
    if (!any(leads)) return;
    set_arms(inputs, motions);
    spread(inputs.finals, motions, finals_);
    const auto outcome = play(inputs.idle);
    const S over = min(excess_.sum() * S(kOverLimitCost), S(kOverLimitMost));
    S result = criteria_.score() + over;
    if (inputs.idle) result = result + idle_.cost();
    const S off = min(outcome.path_error, S(1));
    const auto met = outcome.met(reach.tolerance);
    for (int lane = 0; lane < motions; ++lane) {
      if (!leads[lane]) continue;
      scores[index(lane)] =
          met[lane] ? static_cast<double>(result[lane]) : worst_ + static_cast<double>(off[lane]);
    }
    const std::size_t dofs = rollout_.final_angles().size();
    for (std::size_t k = 0; k < final_angles.size(); ++k) {
      const int lane = static_cast<int>(k / dofs);
      if (leads[lane]) final_angles[k] = rollout_.final_angles()[k % dofs][lane];
    }
  }

 private:
  // Distributes rows (motions × columns) to lanes; unused lanes repeat the last motion.
  static void spread(std::span<const float> rows, int motions, std::span<S> columns) {
    for (int lane = 0; lane < N; ++lane) {
      const int motion = lane < motions ? lane : motions - 1;
      const float* from = rows.data() + index(motion) * columns.size();
      for (std::size_t d = 0; d < columns.size(); ++d) columns[d].set(lane, from[d]);
    }
  }

  // Moves the arms on the paths of the upper motion.
  void set_arms(const LayeredInputs& inputs, int motions) {
    spread(inputs.arms, motions, arms_);
    if (inputs.swivels.empty()) {
      rollout_.find_swivels(swivels_);
    } else {
      spread(inputs.swivels, motions, swivels_);
    }
    rollout_.move_arms({arms_, swivels_, finals_}, true);
  }

  BasicReachOutcome<S> play(bool idle) {
    criteria_.reset();
    excess_.reset();
    idle_.reset();
    const bool held = setup_->problem->reach.hold_limits;
    return rollout_.play(finals_, [this, held, idle](const PlacedFrame<S>& frame) {
      criteria_.add(frame);
      if (held) excess_.add(frame.angles);
      if (idle) idle_.add(frame);
    });
  }

  const LayeredSetup* setup_;
  LayeredRollout<S> rollout_;
  BuiltInCriteria<S> criteria_;
  PassedLimits<S> excess_;
  IdleCost<S> idle_;
  std::vector<S> inverse_weights_;  // (dofs of the upper layer)
  std::vector<S> contractions_;     // (limbs)
  std::vector<S> finals_;           // (final angles)
  std::vector<S> swivels_;          // (arms by swivel)
  std::vector<S> arms_;             // (arms by weights × kArmDofs)
  double worst_;
};

}  // namespace shigusa
