// SPDX-License-Identifier: MIT
#include "layers/reduced_limits.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "rollout/limit_guard.hpp"

namespace shigusa {
namespace {

// The shank's turn by the leg's length goes without bound as the knee gets straight, where no limit
// of the ankle is near: a finite difference over twice this (m), and no more than kMostSlope rad/m.
constexpr double kLengthStep = 1e-4;
constexpr double kMostSlope = 20.0;
// An ankle carries the whole body, and a squat takes it to its limit fast: in less than this it
// could not stop without a jerk.
constexpr double kAnkleMargin = radians(20.0);

}  // namespace

ReducedLimits::ReducedLimits(const ReducedBody& body, std::span<const std::size_t> used)
    : body_(&body), free_(body.dofs.size()) {
  for (const std::size_t d : used) {
    if (body.dofs[d].lower <= -kUnlimited && body.dofs[d].upper >= kUnlimited) continue;
    Limited limited{.dof = d};
    for (const ReducedLimb& limb : body.limbs) {
      if (limb.lean == static_cast<int>(d)) limited.leg = &limb;
    }
    limited_.push_back(limited);
  }
}

void ReducedLimits::reset(std::span<const double> inverse) {
  std::copy(inverse.begin(), inverse.end(), free_.begin());
  for (Limited& limited : limited_) limited.pull = 0.0;
}

double ReducedLimits::shank(const ReducedLimb& leg, double length) const {
  const HingedLimb& segments = leg.joints.segments;
  return segments.direction(segments.bend(length));
}

double ReducedLimits::moved_by(const Limited& limited, std::span<const double> q) const {
  return limited.leg == nullptr ? 0.0 : shank(*limited.leg, q[index(limited.leg->slide)]);
}

void ReducedLimits::soften(std::span<const double> q, std::span<double> inverse) {
  for (Limited& limited : limited_) {
    const ReducedDof& dof = body_->dofs[limited.dof];
    const double angle = q[limited.dof] - moved_by(limited, q);
    const double room = limited.pull > 0.0 ? dof.upper - angle : angle - dof.lower;
    const double margin = limited.leg == nullptr ? kLimitMargin : kAnkleMargin;
    const double t = limited.pull == 0.0 ? 1.0 : clamp(room / margin, 0.0, 1.0);
    limited.share = t * t * (3.0 - 2.0 * t);
    inverse[limited.dof] = free_[limited.dof] * limited.share;
    if (limited.leg == nullptr) continue;
    const double length = q[index(limited.leg->slide)];
    const double rise =
        shank(*limited.leg, length + kLengthStep) - shank(*limited.leg, length - kLengthStep);
    limited.slope = clamp(rise / (2.0 * kLengthStep), -kMostSlope, kMostSlope);
  }
}

void ReducedLimits::lean_with_length(std::span<double> jacobian) const {
  const std::size_t dofs = free_.size();
  for (const Limited& limited : limited_) {
    if (limited.leg == nullptr || limited.share >= 1.0) continue;
    const double lean = (1.0 - limited.share) * limited.slope;
    for (std::size_t row = 0; row < jacobian.size(); row += dofs) {
      jacobian[row + index(limited.leg->slide)] += lean * jacobian[row + limited.dof];
    }
  }
}

void ReducedLimits::learn(std::span<const double> force, std::span<const double> change) {
  for (Limited& limited : limited_) {
    limited.pull = force[limited.dof] * free_[limited.dof];
    if (limited.leg != nullptr) limited.pull -= limited.slope * change[index(limited.leg->slide)];
  }
}

void ReducedLimits::follow_length(std::span<const double> change, std::span<double> q) const {
  for (const Limited& limited : limited_) {
    if (limited.leg == nullptr || limited.share >= 1.0) continue;
    q[limited.dof] += (1.0 - limited.share) * limited.slope * change[index(limited.leg->slide)];
  }
}

void ReducedLimits::hold(std::span<double> q, std::span<double> inverse) const {
  for (const Limited& limited : limited_) {
    const ReducedDof& dof = body_->dofs[limited.dof];
    const double by = moved_by(limited, q);
    const double held = clamp(q[limited.dof], dof.lower + by, dof.upper + by);
    if (held != q[limited.dof]) inverse[limited.dof] = 0.0;
    q[limited.dof] = held;
  }
}

}  // namespace shigusa
