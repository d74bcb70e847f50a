// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rollout/rollout.hpp"
#include "simd/pack.hpp"
#include "stages.hpp"

namespace shigusa::bench {

// Stages for the pack S. Include only in source files that are compiled for a SIMD set: functions
// that are not inlined must have the set's pack in their names, as in PackScorer.
template <class S>
class PackStages final : public Stages {
 public:
  static constexpr int kLanes = ScalarTraits<S>::kLanes;

  explicit PackStages(const StagesInput& input)
      : problem_(*input.problem),
        body_(*problem_.body),
        all_weights_(input.inverse_weights),
        angles_(body_.dofs().size()),
        speeds_(angles_.size(), S(0.3)),
        accelerations_(angles_.size(), S(1.0)),
        torques_(angles_.size()),
        inverse_weights_(angles_.size(), S(1)),
        kinematics_(body_),
        ik_(body_),
        dynamics_(body_),
        criteria_(body_, problem_.context, *input.criteria),
        rollout_(problem_, LostMotion::left) {
    // offset from the start posture, so that no value is 0
    for (std::size_t d = 0; d < angles_.size(); ++d) {
      angles_[d] = S(problem_.start().angles[d] + 0.05);
    }
    for (const Constraint<double>& constraint : constraints(problem_)) {
      constraints_.push_back(in_lanes<S>(constraint));
    }
    rows_ = ik_detail::row_count<S>(constraints_);
    run(Stage::forward_kinematics);
    run(Stage::ik_rows);
    run(Stage::ik_products);
    for (int i = 0; i < rows_; ++i) residual_[i] = ik_.residual[i];
    diagonal_ = ik_detail::add_damping<S>(constraints_, problem_.ik, ik_);
  }

  [[nodiscard]] int lanes() const override { return kLanes; }

  void run(Stage stage) override {
    switch (stage) {
      case Stage::forward_kinematics:
        return forward_kinematics<S>(body_, angles_, kinematics_);
      case Stage::ik_rows:
        return ik_detail::fill_rows<S>(body_, kinematics_, constraints_, ik_);
      case Stage::ik_products:
        return ik_detail::fill_products<S>(rows_ / 3, inverse_weights_, ik_);
      case Stage::ik_solve:
        for (int i = 0; i < rows_; ++i) ik_.residual[i] = residual_[i];
        return ik_detail::solve<S>(rows_, diagonal_ * S(kIkPivotFloor<float>), ik_);
      case Stage::ik:
        (void)weighted_ik_step<S>(body_, kinematics_, {constraints_, inverse_weights_}, problem_.ik,
                                  ik_);
        return;
      case Stage::dynamics:
        return dynamics();
      case Stage::criteria:
        return criteria_.add(MotionFrame<S>{angles_, torques_, centre_});
      case Stage::motion:
        return motion();
    }
  }

  void peak() override {
    // near 1 and 0, so that values stay in range
    const S factor = opaque(S(1.0F - 0x1p-24F));
    const S term = opaque(S(0x1p-30F));
    S products[kPeakChains];
    S sums[kPeakChains];
    for (int k = 0; k < kPeakChains; ++k) {
      products[k] = opaque(S(1));
      sums[k] = opaque(S(0));
    }
    for (int round = 0; round < kPeakRounds; ++round) {
#pragma GCC unroll 8
      for (int k = 0; k < kPeakChains; ++k) {
        products[k] = products[k] * factor;
        sums[k] = sums[k] + term;
      }
    }
    for (int k = 0; k < kPeakChains; ++k) torques_[0] = torques_[0] + (products[k] + sums[k]);
  }

 private:
  // same values, but unknown to the compiler
  static S opaque(S s) {
    asm volatile("" : "+m"(s.lanes));
    return s;
  }

  void dynamics() {
    const Wrench<S> ground =
        inverse_dynamics<S>(body_, kinematics_, {speeds_, accelerations_}, dynamics_, torques_);
    if (body_.feet().size() == 2) {
      share_ground_wrench<S>(body_, kinematics_, {}, ground, torques_);
    }
    centre_ = centre_of_mass<S>(body_, dynamics_);
  }

  void motion() {
    const std::size_t dofs = angles_.size();
    for (int lane = 0; lane < kLanes; ++lane) {
      const float* from =
          all_weights_.data() + (next_motion_ + static_cast<std::size_t>(lane)) * dofs;
      for (std::size_t d = 0; d < dofs; ++d) motion_weights_[d].set(lane, from[d]);
    }
    next_motion_ += static_cast<std::size_t>(kLanes);
    if ((next_motion_ + static_cast<std::size_t>(kLanes)) * dofs > all_weights_.size()) {
      next_motion_ = 0;
    }
    criteria_.reset();
    const auto outcome =
        rollout_.run(motion_weights_, [this](const PlacedFrame<S>& f) { criteria_.add(f); });
    scores_ = select(outcome.met(problem_.tolerance), criteria_.score(), S(1));
  }

  const ReachProblem& problem_;
  const BodyModel& body_;
  std::span<const float> all_weights_;
  std::size_t next_motion_ = 0;
  std::vector<S> angles_;
  std::vector<S> speeds_;
  std::vector<S> accelerations_;
  std::vector<S> torques_;
  std::vector<S> inverse_weights_;
  std::vector<S> motion_weights_ = inverse_weights_;
  std::vector<Constraint<S>> constraints_;
  int rows_ = 0;
  S residual_[kMaxIkRows];
  S diagonal_;
  S scores_;
  Vec3<S> centre_;
  Kinematics<S> kinematics_;
  IkWorkspace<S> ik_;
  DynamicsWorkspace<S> dynamics_;
  BuiltInCriteria<S> criteria_;
  Rollout<S> rollout_;
};

}  // namespace shigusa::bench
