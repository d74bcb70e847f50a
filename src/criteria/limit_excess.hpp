// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "body/coupled_limits.hpp"

namespace shigusa {

// Excess (rad) below which a passed limit is invisible.
inline constexpr double kSeenExcess = radians(0.1);

// Excess of a motion's joints over their limits, frame by frame. The body outlives the object.
template <class S>
class PassedLimits {
 public:
  explicit PassedLimits(const BodyModel& body)
      : body_(&body), coupled_(body), most_(body.dofs().size()) {}

  void reset() {
    for (S& most : most_) most = S(0);
  }

  void add(std::span<const S> angles) {
    coupled_.update(angles);
    for (std::size_t d = 0; d < most_.size(); ++d) {
      const Dof& dof = body_->dofs()[d];
      const S above = angles[d] - (S(dof.upper) + coupled_.added()[d]);
      most_[d] = max(most_[d], max(above, S(dof.lower) - angles[d]));
    }
  }

  // (dofs) rad, the largest excess so far; 0 within the limits.
  [[nodiscard]] std::span<const S> most() const { return most_; }

  // Σ over the joints beyond a limit of (each + the largest excess in rad).
  [[nodiscard]] S sum(double each = 0.0) const {
    S sum(0);
    for (const S& most : most_) sum = sum + select(most > S(kSeenExcess), most + S(each), S(0));
    return sum;
  }

 private:
  const BodyModel* body_;
  CoupledLimits<S> coupled_;
  std::vector<S> most_;  // (dofs) rad
};

}  // namespace shigusa
