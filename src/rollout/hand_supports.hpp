// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Moves the constraints of the hands that rest in a motion, frame by frame, and tells what they
// bear. Hands are not constrained in lanes in which they are free, where PostureLaw moves their
// arms. Most motions have none, so the functions are kept out of line.
template <class S>
class HandSupports {
 public:
  explicit HandSupports(const ReachProblem& problem)
      : problem_(&problem), shares_(problem.supports.size()) {
    for (std::size_t k = 0; k < shares_.size(); ++k) {
      const Effector& hand = problem.body->effector(problem.supports[k].effector);
      for (const int d : problem.body->chain(hand.link)) {
        if (d >= hand.limb_root) arms_.push_back({index(d), k, S(0)});
      }
    }
  }

  [[nodiscard]] bool empty() const { return shares_.empty(); }

  // Begins a motion with the given shares (supports) or none; returns the shares that the hands
  // bear.
  std::span<const S> begin(std::span<const S> shares, std::span<Constraint<S>> hands) {
    for (std::size_t k = 0; k < hands.size(); ++k) {
      const S share = shares.empty() ? S(0) : shares[k];
      hands[k].active = select(share < S(0), S(0), S(1));
      shares_[k] = max(share, S(0));
    }
    return shares_;
  }

  // Sets the hands' places for this frame, from their positions in the frame before.
  [[gnu::noinline]] void place(int frame, const Kinematics<S>& before,
                               std::span<Constraint<S>> hands) const {
    for (std::size_t k = 0; k < hands.size(); ++k) {
      const HandSupport& support = problem_->supports[k];
      const Vec3<S> rest = to_scalar<S>(support.place);
      const Vec3<S> from = seen_from_carrier(hands[k], before);
      const double now = time(frame);
      const double last = max(now - 1.0 / problem_->steps, 0.0);
      const S share(share_of_rest(support.done(last), support.done(now)));
      const S lift(support.lift(now) - support.lift(last));
      hands[k].place = from + (rest - from) * share + to_scalar<S>(support.normal) * lift;
      if (hands[k].holds_at(now)) hands[k].place = rest;
    }
  }

  // Sets the hands' places for this frame to their present positions, or after arrival to their
  // resting places.
  [[gnu::noinline]] void keep(int frame, const Kinematics<S>& kinematics,
                              std::span<Constraint<S>> hands) const {
    for (std::size_t k = 0; k < hands.size(); ++k) {
      hands[k].place = hands[k].holds_at(time(frame)) ? to_scalar<S>(problem_->supports[k].place)
                                                      : seen_from_carrier(hands[k], kinematics);
    }
  }

  // Saves the reference of the arms (dofs, rad), and restores it in proportion to the hands'
  // progress: the posture law applies to free arms.
  [[gnu::noinline]] void keep_arms(std::span<const S> reference) {
    for (ArmFreedom& arm : arms_) arm.kept = reference[arm.dof];
  }
  [[gnu::noinline]] void restore_arms(int frame, std::span<const Constraint<S>> hands,
                                      std::span<S> reference) const {
    for (const ArmFreedom& arm : arms_) {
      const double done = problem_->supports[arm.support].done(time(frame));
      const S share = hands[arm.support].active * S(done);
      S& drawn = reference[arm.dof];
      drawn = drawn + (arm.kept - drawn) * share;
    }
  }

 private:
  struct ArmFreedom {
    std::size_t dof = 0;
    std::size_t support = 0;
    S kept{};  // rad
  };

  // Position of the hand's point in the carrier's frame.
  static Vec3<S> seen_from_carrier(const Constraint<S>& hand, const Kinematics<S>& kinematics) {
    const Vec3<S> at = kinematics.point(hand.link, hand.point);
    if (hand.carrier == kWorldCarrier) return at;
    return transpose_times(kinematics.link_rotation(hand.carrier),
                           at - kinematics.link_origin(hand.carrier));
  }

  // Share of the duration.
  [[nodiscard]] double time(int frame) const {
    return static_cast<double>(frame) / problem_->steps;
  }

  const ReachProblem* problem_;
  std::vector<S> shares_;  // (supports), 0 or more
  std::vector<ArmFreedom> arms_;
};

}  // namespace shigusa
