// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/criteria/motion_frame.hpp>
#include <shigusa/motion/motion.hpp>
#include <vector>

namespace shigusa {

// Share of a joint's range by which a limit may be passed until the penalty is full (rule R8a).
inline constexpr double kRangeMargin = 0.2;

struct JointRangeSettings {
  double margin = kRangeMargin;  // share of the range, > 0
};

// The upper limit (rad) of a dof at the given angles (dofs), with what the body's couplings add.
template <class S>
[[nodiscard]] S upper_limit(const BodyModel& body, int dof, std::span<const S> angles) {
  S upper(body.dof(dof).upper);
  for (const LimitCoupling& c : body.couplings()) {
    if (c.dof != dof) continue;
    const S driver = angles[static_cast<std::size_t>(c.driver)] * S(1.0 / c.driver_full);
    upper = upper + S(c.gain) * clamp(driver, S(0), S(1));
  }
  return upper;
}

// How far joints pass their limits, during the motion or at its end, in [0, 1] (paper, section
// 3.3; rule R8a):
//   v_i = min(1, max_t excess_i(t) / (margin · (q_i⁺ - q_i⁻))),   P = ½ max_i v_i + ½ mean_i v_i.
template <class S>
class JointRange {
 public:
  explicit JointRange(const BodyModel& body, const JointRangeSettings& settings = {})
      : body_(&body), margin_(settings.margin), worst_(body.dofs().size(), S(0)) {}

  void add(const MotionFrame<S>& frame) {
    for (int i = 0; i < body_->dof_count(); ++i) {
      const Dof& dof = body_->dof(i);
      const auto k = static_cast<std::size_t>(i);
      const S above = frame.angles[k] - upper_limit(*body_, i, frame.angles);
      const S below = S(dof.lower) - frame.angles[k];
      const S scale(1.0 / (margin_ * (dof.upper - dof.lower)));
      worst_[k] = max(worst_[k], max(above, below) * scale);
    }
  }

  [[nodiscard]] S penalty() const {
    S largest(0);
    S sum(0);
    for (const S& worst : worst_) {
      const S v = min(worst, S(1));
      largest = max(largest, v);
      sum = sum + v;
    }
    return S(0.5) * largest + S(0.5) * sum * S(1.0 / static_cast<double>(worst_.size()));
  }

 private:
  const BodyModel* body_;
  double margin_;
  std::vector<S> worst_;  // (dofs) largest excess so far, as a share of the margin
};

// The penalty of a whole motion.
[[nodiscard]] double joint_range_penalty(const BodyModel& body, const Motion& motion,
                                         const JointRangeSettings& settings = {});

}  // namespace shigusa
