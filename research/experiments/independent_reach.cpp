// SPDX-License-Identifier: MIT
#include "independent_reach.hpp"

#include <algorithm>
#include <string>

#include "core/check.hpp"

namespace shigusa::bench {
namespace {

constexpr int kIterations = 150;
// Curvature along directions free of hand and feet, relative to m²/rad² of limbs.
constexpr double kLeastCurvature = 1e-4;

}  // namespace

IndependentReach::IndependentReach(const PosedBody& posed, std::string_view effector)
    : body_(posed.body),
      home_(posed.home.angles),
      size_(home_.size(), 1.0),
      angles_(home_),
      placed_(body_),
      metric_(body_.dof_count()) {
  const BodyModel& body = posed.body;
  const auto index = body.find_effector(effector);
  SHG_CHECK(index.has_value(), "no effector " + std::string(effector));
  const Effector& hand = body.effectors()[static_cast<std::size_t>(*index)];
  held_.push_back({hand.link, hand.point, {}});
  forward_kinematics<double>(body, angles_, placed_);
  for (const Foot& foot : body.feet()) {
    if (foot.link == kBaseLink) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      held_.push_back({foot.link, foot.outline[k], placed_.point(foot.link, foot.outline[k])});
    }
  }
  add_limits();
}

// An upper limit that depends on another angle is the lower of two planes; for negative angles the
// slanting one is slightly stricter than the limit.
void IndependentReach::add_limits() {
  const std::vector<double>& start = home_;
  for (int d = 0; d < body_.dof_count(); ++d) {
    const Dof& dof = body_.dof(d);
    const auto k = static_cast<std::size_t>(d);
    double most = dof.upper;
    for (const LimitCoupling& c : body_.couplings()) {
      if (c.dof != d) continue;
      most += c.gain;
      const double slope = c.gain / c.driver_full;
      const double length = sqrt(1.0 + slope * slope);
      const double room = dof.upper + slope * start[static_cast<std::size_t>(c.driver)] - start[k];
      limits_.push_back({d, c.driver, 1.0 / length, -slope / length, max(0.0, room / length)});
    }
    limits_.push_back({d, d, 1.0, 0.0, max(0.0, most - start[k])});
    limits_.push_back({d, d, -1.0, 0.0, max(0.0, start[k] - dof.lower)});
  }
}

double IndependentReach::evaluate(std::span<const double> z, std::span<double> gradient) {
  for (std::size_t d = 0; d < z.size(); ++d) {
    angles_[d] = home_[d] + z[d];
    gradient[d] = 0.0;
  }
  forward_kinematics<double>(body_, angles_, placed_);
  double value = 0.0;
  for (const Held& held : held_) {
    const Vec3d at = placed_.point(held.link, held.point);
    const Vec3d off = at - held.place;
    value += 0.5 * dot(off, off);
    for (const int d : body_.chain(held.link)) {
      gradient[static_cast<std::size_t>(d)] += dot(off, position_column(placed_, d, at));
    }
  }
  return value;
}

bool IndependentReach::descend(std::span<double> z) {
  std::vector<double> gradient(z.size());
  (void)evaluate(z, gradient);
  rows_.assign(3 * held_.size() * z.size(), 0.0);
  for (std::size_t h = 0; h < held_.size(); ++h) {
    const Vec3d at = placed_.point(held_[h].link, held_[h].point);
    for (const int d : body_.chain(held_[h].link)) {
      const Vec3d column = position_column(placed_, d, at);
      for (std::size_t i = 0; i < 3; ++i) {
        rows_[(3 * h + i) * z.size() + static_cast<std::size_t>(d)] = column[static_cast<int>(i)];
      }
    }
  }
  metric_.reset();
  metric_.set_curvature(kLeastCurvature, rows_);
  metric_.minimise(*this, limits_, size_, {.tolerance = 1e-8, .iterations = kIterations}, z);
  (void)evaluate(z, gradient);
  for (const Held& held : held_) {
    if (norm(placed_.point(held.link, held.point) - held.place) > kThere) return false;
  }
  return true;
}

std::optional<std::vector<double>> IndependentReach::posture(const Vec3d& goal, int starts,
                                                             Random& random) {
  held_[0].place = goal;
  std::vector<double> z(angles_.size());
  for (int s = 0; s <= starts; ++s) {
    for (std::size_t d = 0; d < z.size(); ++d) {
      const Dof& dof = body_.dof(static_cast<int>(d));
      z[d] = s == 0 ? 0.0 : random.uniform(dof.lower, dof.upper) - home_[d];
    }
    if (descend(z)) return angles_;
  }
  return std::nullopt;
}

double excess_of(const BodyModel& body, std::span<const double> angles) {
  double most = 0.0;
  for (int d = 0; d < body.dof_count(); ++d) {
    double upper = body.dof(d).upper;
    for (const LimitCoupling& c : body.couplings()) {
      if (c.dof != d) continue;
      const double share = angles[static_cast<std::size_t>(c.driver)] / c.driver_full;
      upper += c.gain * clamp(share, 0.0, 1.0);
    }
    const double angle = angles[static_cast<std::size_t>(d)];
    most = std::max({most, angle - upper, body.dof(d).lower - angle});
  }
  return most;
}

}  // namespace shigusa::bench
