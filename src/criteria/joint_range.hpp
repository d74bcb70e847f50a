// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <vector>

#include "body/coupled_limits.hpp"
#include "criteria/motion_frame.hpp"

namespace shigusa {

// Penalty of joints beyond their limits, during the motion or at its end, in [0, 1] (paper, section
// 3.3; rule R8a):
//   v_i = min(1, max_t excess_i(t) / (margin · (q_i⁺ - q_i⁻))),   P = ½ max_i v_i + ½ mean_i v_i.
template <class S>
class JointRange {
 public:
  static constexpr CriterionKind kKind = CriterionKind::joint_range;

  JointRange(const BodyModel& body, const CriteriaContext&, double margin) : coupled_(body) {
    for (const Dof& dof : body.dofs()) {
      limits_.push_back({static_cast<T>(dof.lower), static_cast<T>(dof.upper),
                         static_cast<T>(1.0 / (margin * (dof.upper - dof.lower)))});
    }
    lowest_.resize(limits_.size());
    highest_.resize(limits_.size());
    reset();
  }

  void reset() {
    for (std::size_t k = 0; k < limits_.size(); ++k) {
      lowest_[k] = S(kUnseen);
      highest_[k] = S(-kUnseen);
    }
  }

  void add(const MotionFrame<S>& frame) {
    coupled_.update(frame.angles);
    // relative to the fixed upper limits: reduced by the couplings' addition to the limit
    for (std::size_t k = 0; k < limits_.size(); ++k) {
      lowest_[k] = min(lowest_[k], frame.angles[k]);
      highest_[k] = max(highest_[k], frame.angles[k] - coupled_.added()[k]);
    }
  }

  [[nodiscard]] S penalty() const {
    S largest(0);
    S sum(0);
    for (std::size_t k = 0; k < limits_.size(); ++k) {
      const S excess = max(highest_[k] - S(limits_[k].upper), S(limits_[k].lower) - lowest_[k]);
      const S v = clamp(excess * S(limits_[k].per_margin), S(0), S(1));
      largest = max(largest, v);
      sum = sum + v;
    }
    return S(0.5) * largest + S(0.5) * sum * S(1.0 / static_cast<double>(limits_.size()));
  }

 private:
  using T = Element<S>;
  static constexpr double kUnseen = 1e30;  // rad
  struct Limit {
    T lower;
    T upper;
    T per_margin;
  };

  std::vector<Limit> limits_;
  CoupledLimits<S> coupled_;
  std::vector<S> lowest_;   // (dofs) rad, so far
  std::vector<S> highest_;  // (dofs) rad, so far, reduced by the couplings' addition
};

}  // namespace shigusa
