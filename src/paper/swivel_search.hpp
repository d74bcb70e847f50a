// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "criteria/built_in_criteria.hpp"
#include "criteria/limit_excess.hpp"
#include "motion/jolt.hpp"
#include "paper/arm_feedback.hpp"
#include "rollout/frame_dynamics.hpp"

namespace shigusa {

// Cost, in addition to the layer's criteria, of a swivel that exceeds joint limits or jolts: it is
// chosen only if all others do.
inline constexpr double kSwivelOver = 1.0;
// Weight of the cost P = min(1, depth / kCollisionFull) of a swivel that leads the arm into the
// body.
inline constexpr double kSwivelCollisionWeight = 2.0;

// The frames by which a swivel is scored: all, or one in kCoarseFrames.
enum class Pace { each_frame, coarse };

// Chooses the swivel of one arm on a hand's path. S is double, or a pack whose lanes have separate
// paths. Owns scratch memory: one per thread. The setup outlives it.
template <class S>
class SwivelSearch {
 public:
  SwivelSearch(const LayeredSetup& setup, std::size_t goal, Pace pace = Pace::each_frame)
      : pace_(pace),
        range_(&setup.problem->layers[1 + goal].parameters.front()),
        body_(&setup.problem->arm_bodies[goal].body),
        moved_(setup.problem->arm_bodies[goal], setup.arm(goal)),
        placed_(*body_),
        dynamics_(pace == Pace::each_frame ? setup.alone[goal] : setup.alone_coarsely[goal]),
        criteria_(*body_, setup.alone[goal].context, setup.problem->layers[1 + goal].criteria),
        excess_(*body_),
        near_(3, std::vector<S>(body_->dofs().size())) {}

  // Sets the path of all following motions, with every frame; `feedback` holds the obstacles, if
  // any.
  void follow(std::span<const Vec3<S>> path, const HandTurn<S>& turn,
              const ArmFeedback* feedback = nullptr) {
    const std::size_t stride = pace_ == Pace::each_frame ? 1 : kCoarseFrames;
    frames_ = (path.size() - 1) / stride + 1;
    seen_.resize(frames_);
    for (std::size_t f = 0; f < frames_; ++f) seen_[f] = path[f * stride];
    moved_.follow(seen_, turn);
    feedback_ = feedback;
  }

  // The best of a few swivels, for the search of the layer above.
  [[nodiscard]] S coarse() { return best_of_grid(kCoarsePoints).swivel; }
  // The best of a finer grid, refined by a golden-section search.
  [[nodiscard]] S fine() {
    Best best = best_of_grid(kGridPoints);
    const S step((range_->high - range_->low) / (kGridPoints - 1));
    S low = max(best.swivel - step, S(range_->low));
    S high = min(best.swivel + step, S(range_->high));
    const auto at = [&](const S& share) {
      const S swivel = low + share * (high - low);
      const S scored = score(swivel);
      take(best, {swivel, scored});
      return scored;
    };
    S below = at(S(1.0 - kGolden));
    S above = at(S(kGolden));
    for (int k = 0; k < kGoldenSteps; ++k) {
      const auto falls = below < above;
      const S width = S(kGolden) * (high - low);
      low = select(falls, low, high - width);
      high = select(falls, low + width, high);
      const S between = at(select(falls, S(1.0 - kGolden), S(kGolden)));
      const S other = select(falls, below, above);
      below = select(falls, between, other);
      above = select(falls, other, between);
    }
    return best.swivel;
  }

 private:
  static constexpr int kCoarsePoints = 6;  // every 30°
  static constexpr int kGridPoints = 11;   // every 15°
  static constexpr int kGoldenSteps = 6;   // to within a degree
  static constexpr double kGolden = 0.6180339887498949;
  static constexpr double kSameSwivel = radians(0.1);

  struct Best {
    S swivel{};  // rad
    S score{};
  };

  static void take(Best& best, const Best& other) {
    const auto better = other.score < best.score;
    best.swivel = select(better, other.swivel, best.swivel);
    best.score = select(better, other.score, best.score);
  }

  Best best_of_grid(int points) {
    Best best{S(0), score(S(0))};
    for (int k = 0; k < points; ++k) {
      const double swivel =
          min(range_->high, range_->low + (range_->high - range_->low) * k / (points - 1));
      if (abs(swivel) < kSameSwivel) continue;
      take(best, {S(swivel), score(S(swivel))});
    }
    return best;
  }

  // Appends the angles of a frame to near_.
  void take_frame(std::size_t frame) {
    std::rotate(near_.begin(), near_.begin() + 1, near_.end());
    const std::size_t dofs = near_[2].size();
    for (std::size_t d = 0; d < dofs; ++d) near_[2][d] = angles_[frame * dofs + d];
  }

  // Largest change of a joint's step (rad) at the middle frame of near_.
  S jolt() const {
    S most(0);
    for (std::size_t d = 0; d < near_[1].size(); ++d) {
      most = max(most, abs((near_[2][d] - near_[1][d]) - (near_[1][d] - near_[0][d])));
    }
    return most;
  }

  S score(const S& swivel) {
    moved_.run(swivel, angles_);
    criteria_.reset();
    excess_.reset();
    depth_.begin(feedback_);
    S jolted(0);
    take_frame(0);
    take_frame(0);
    for (std::size_t f = 0; f < frames_; ++f) {
      take_frame(std::min(f + 1, frames_ - 1));
      forward_kinematics<S>(*body_, near_[1], placed_);
      criteria_.add(dynamics_.frame(near_, placed_));
      excess_.add(near_[1]);
      depth_.add(placed_);
      if (f > 0 && f + 1 < frames_) jolted = max(jolted, jolt());
    }
    const S depth = clamp(depth_.deepest() * S(1.0 / kCollisionFull), S(0), S(1));
    const double most = pace_ == Pace::each_frame ? kJolt : kCoarseFrames * kCoarseFrames * kJolt;
    return excess_.sum(kSwivelOver) + select(jolted > S(most), S(kSwivelOver), S(0)) +
           depth * S(kSwivelCollisionWeight) + criteria_.score();
  }

  Pace pace_;
  const ParameterInfo* range_;
  const BodyModel* body_;
  SwivelArm<S> moved_;
  const ArmFeedback* feedback_ = nullptr;
  std::size_t frames_ = 0;
  std::vector<Vec3<S>> seen_;  // (frames) of the path
  Kinematics<S> placed_;
  FrameDynamics<S> dynamics_;
  BuiltInCriteria<S> criteria_;
  PassedLimits<S> excess_;
  ArmDepth<S> depth_;
  std::vector<S> angles_;             // (frames × dofs) rad, of the motion being scored
  std::vector<std::vector<S>> near_;  // (dofs) rad, of the frame before, this one and the next
};

}  // namespace shigusa
