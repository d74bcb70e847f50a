// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Targets of the resting hands of a motion, frame by frame. In lanes whose hand is free it is no
// target, and PostureLaw moves its arm. Most motions have none, so the functions are kept out of
// line.
template <class S>
class HandSupports {
 public:
  explicit HandSupports(const ReachProblem& problem) {
    const BodyModel& body = *problem.body;
    for (const IkSupport<double>& support : ik_supports(problem)) {
      targets_.push_back({.link = support.link,
                          .point = to_scalar<Element<S>>(support.point),
                          .carrier = support.carrier,
                          .place = to_scalar<S>(support.place)});
    }
    for (const HandSupport& support : problem.supports) {
      rests_.push_back(
          {to_scalar<Element<S>>(support.place), to_scalar<Element<S>>(support.normal)});
    }
    shares_.resize(targets_.size());
    leads_.resize(targets_.size());
    if (empty()) return;
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
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      const int root = body.effector(problem.supports[k].effector).limb_root;
      for (const int d : body.chain(targets_[k].link)) {
        if (d >= root) arms_.push_back({index(d), k, S(0)});
      }
    }
  }

  [[nodiscard]] bool empty() const { return targets_.empty(); }
  [[nodiscard]] std::span<const IkSupport<S>> targets() const { return targets_; }

  // Begins a motion with the given shares (supports) or none; returns the shares that the hands
  // bear.
  std::span<const S> begin(std::span<const S> shares) {
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      const S share = shares.empty() ? S(0) : shares[k];
      targets_[k].holds = select(share < S(0), S(0), S(1));
      targets_[k].lead = {};
      shares_[k] = max(share, S(0));
    }
    return shares_;
  }

  // Sets the hands' targets for this frame, from their positions in the frame before.
  [[gnu::noinline]] void place(int frame, const Kinematics<S>& before) {
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      const Moment& moment = at(frame, k);
      IkSupport<S>& target = targets_[k];
      const Vec3<S> rest = to_scalar<S>(rests_[k].place);
      const Vec3<S> from = seen_from_carrier(target, before);
      target.place =
          from + (rest - from) * S(moment.share) + to_scalar<S>(rests_[k].normal) * S(moment.lift);
      if (moment.there) target.place = rest;
    }
  }

  // Sets the hands' targets for this frame to their present positions, or after arrival to their
  // resting places.
  [[gnu::noinline]] void keep(int frame, const Kinematics<S>& kinematics) {
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      IkSupport<S>& target = targets_[k];
      target.lead = {};
      target.place = at(frame, k).there ? to_scalar<S>(rests_[k].place)
                                        : seen_from_carrier(target, kinematics);
    }
  }

  // Saves and clears the leads, which apply only to a frame's first step.
  void put_leads_aside() {
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      leads_[k] = targets_[k].lead;
      targets_[k].lead = {};
    }
  }
  void put_leads_back() {
    for (std::size_t k = 0; k < targets_.size(); ++k) targets_[k].lead = leads_[k];
  }

  // Saves the reference of the arms (dofs, rad), and restores it in proportion to the hands'
  // progress: the posture law applies to free arms.
  [[gnu::noinline]] void keep_arms(std::span<const S> reference) {
    for (ArmFreedom& arm : arms_) arm.kept = reference[arm.dof];
  }
  [[gnu::noinline]] void restore_arms(int frame, std::span<S> reference) const {
    for (const ArmFreedom& arm : arms_) {
      const S share = targets_[arm.support].holds * S(at(frame, arm.support).done);
      S& drawn = reference[arm.dof];
      drawn = drawn + (arm.kept - drawn) * share;
    }
  }

  // Largest error (m) of the hands that have arrived; `learn`: adds the error to the leads of hands
  // within `limit` (m).
  [[gnu::noinline]] S miss(int frame, const Kinematics<S>& kinematics, const S& limit, bool learn) {
    S most(0);
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      if (!at(frame, k).there) continue;
      IkSupport<S>& target = targets_[k];
      const Vec3<S> error = support_error(kinematics, target);
      const S off = norm(error);
      if (learn) target.lead = select(off < limit, target.lead + error, Vec3<S>{});
      most = max(off, most) + (most - most);
    }
    return most;
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
  static Vec3<S> seen_from_carrier(const IkSupport<S>& hand, const Kinematics<S>& kinematics) {
    const Vec3<S> at = kinematics.point(hand.link, hand.point);
    if (hand.carrier == kWorldCarrier) return at;
    return transpose_times(kinematics.link_rotation(hand.carrier),
                           at - kinematics.link_origin(hand.carrier));
  }

  [[nodiscard]] const Moment& at(int frame, std::size_t support) const {
    return moments_[index(frame) * targets_.size() + support];
  }

  std::vector<IkSupport<S>> targets_;
  std::vector<S> shares_;        // (supports), 0 or more
  std::vector<Vec3<S>> leads_;   // saved while a frame is corrected
  std::vector<Rest> rests_;      // (supports)
  std::vector<Moment> moments_;  // (frames × supports)
  std::vector<ArmFreedom> arms_;
};

}  // namespace shigusa
