// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "body/coupled_limits.hpp"

namespace shigusa {

// Less of a limit's excess than a tenth of a degree is nothing that anyone sees.
inline constexpr double kSeenExcess = radians(0.1);

// How far a motion's joints pass their limits, frame by frame. The body outlives it.
template <class S>
class PassedLimits {
 public:
  explicit PassedLimits(const BodyModel& body)
      : body_(&body), coupled_(body), most_(body.dofs().size()) {}

  // Forgets the frames seen.
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

  // (dofs) rad, the most of each so far; 0 within.
  [[nodiscard]] std::span<const S> most() const { return most_; }

  // Σ over the joints that were beyond a limit of (each + the largest excess in rad).
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
