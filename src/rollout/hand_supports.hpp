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
  explicit HandSupports(const ReachProblem& problem) {
    const BodyModel& body = *problem.body;
    for (const HandSupport& support : problem.supports) {
      rests_.push_back(
          {to_scalar<Element<S>>(support.place), to_scalar<Element<S>>(support.normal)});
    }
    shares_.resize(rests_.size());
    for (int frame = 0; frame <= problem.steps; ++frame) {
      const double tau = static_cast<double>(frame) / problem.steps;
      for (const HandSupport& support : problem.supports) {
        const double before = max(tau - 1.0 / problem.steps, 0.0);
        const double done = support.done(tau);
        moments_.push_back({static_cast<Element<S>>(done),
                            static_cast<Element<S>>(share_of_rest(support.done(before), done)),
                            static_cast<Element<S>>(support.lift(tau) - support.lift(before)),
                            tau >= support.arrives});
      }
    }
    for (std::size_t k = 0; k < rests_.size(); ++k) {
      const Effector& hand = body.effector(problem.supports[k].effector);
      for (const int d : body.chain(hand.link)) {
        if (d >= hand.limb_root) arms_.push_back({index(d), k, S(0)});
      }
    }
  }

  [[nodiscard]] bool empty() const { return rests_.empty(); }

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
      const Moment& moment = at(frame, k);
      const Vec3<S> rest = to_scalar<S>(rests_[k].place);
      const Vec3<S> from = seen_from_carrier(hands[k], before);
      hands[k].place =
          from + (rest - from) * S(moment.share) + to_scalar<S>(rests_[k].normal) * S(moment.lift);
      if (moment.there) hands[k].place = rest;
    }
  }

  // Sets the hands' places for this frame to their present positions, or after arrival to their
  // resting places.
  [[gnu::noinline]] void keep(int frame, const Kinematics<S>& kinematics,
                              std::span<Constraint<S>> hands) const {
    for (std::size_t k = 0; k < hands.size(); ++k) {
      hands[k].place = at(frame, k).there ? to_scalar<S>(rests_[k].place)
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
      const S share = hands[arm.support].active * S(at(frame, arm.support).done);
      S& drawn = reference[arm.dof];
      drawn = drawn + (arm.kept - drawn) * share;
    }
  }

 private:
  using T = Element<S>;
  // Resting place of a hand (m, and a unit normal), in the frame of its carrier.
  struct Rest {
    Vec3<T> place;
    Vec3<T> normal;
  };
  // Progress of a hand in one frame.
  struct Moment {
    T done;      // of its way
    T share;     // of its remaining way
    T lift;      // m, added along the normal
    bool there;  // after its arrival
  };
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

  [[nodiscard]] const Moment& at(int frame, std::size_t support) const {
    return moments_[index(frame) * rests_.size() + support];
  }

  std::vector<S> shares_;        // (supports), 0 or more
  std::vector<Rest> rests_;      // (supports)
  std::vector<Moment> moments_;  // (frames × supports)
  std::vector<ArmFreedom> arms_;
};

}  // namespace shigusa
