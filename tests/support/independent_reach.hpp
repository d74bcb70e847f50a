// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rollout/reach_problem.hpp"
#include "support/bodies.hpp"

// A second computation of the closest approach to goals, which shares with the library only the
// placement of links: Levenberg and Marquardt's method from random postures, with the planted feet
// as a penalty that grows until they stand.
namespace shigusa::testing_support {

class IndependentReach {
 public:
  explicit IndependentReach(const ReachProblem& problem)
      : body_(*problem.body), targets_(constraints(problem)) {
    goal_rows_ = 3 * static_cast<Eigen::Index>(problem.goals.size());
  }

  // The least distance (m) to the goals that is found from `starts` random postures, or infinity
  // where the feet never come to stand.
  [[nodiscard]] double distance(int starts, Random& random) {
    double best = std::numeric_limits<double>::infinity();
    for (int s = 0; s < starts; ++s) {
      const std::vector<double> start = random_posture(body_, random);
      q_ = Eigen::Map<const Eigen::VectorXd>(start.data(), body_.dof_count());
      for (const double penalty : {1.0, 30.0, 1000.0}) descend(penalty);
      const Eigen::VectorXd misses = evaluate(q_, 1.0).residual;
      const bool stands = misses.tail(misses.size() - goal_rows_).norm() < 1e-4;
      if (stands) best = std::fmin(best, misses.head(goal_rows_).norm());
    }
    return best;
  }

 private:
  struct System {
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;
  };

  void descend(double penalty) {
    System now = evaluate(q_, penalty);
    double damping = 1e-2;
    for (int k = 0; k < 60 && damping < 1e8; ++k) {
      Eigen::MatrixXd normal = now.jacobian.transpose() * now.jacobian;
      normal.diagonal().array() += damping;
      const Eigen::VectorXd trial =
          q_ - normal.ldlt().solve(now.jacobian.transpose() * now.residual);
      System next = evaluate(trial, penalty);
      const double gain = now.residual.squaredNorm() - next.residual.squaredNorm();
      if (!(gain > 0.0)) {
        damping *= 6.0;
        continue;
      }
      q_ = trial;
      now = std::move(next);
      damping = std::fmax(1e-10, 0.3 * damping);
      if (gain < 1e-13) return;
    }
  }

  // goals' misses, then penalty × the feet's: 3 rows for the place, 3 for the turn at 0.1 m/rad
  [[nodiscard]] System evaluate(const Eigen::VectorXd& q, double penalty) const {
    const Kinematics<double> kinematics =
        placed(body_, {q.data(), static_cast<std::size_t>(q.size())});
    System system;
    Eigen::Index rows = 0;
    for (const Constraint<double>& target : targets_) rows += target.exact ? 6 : 3;
    system.residual = Eigen::VectorXd::Zero(rows);
    system.jacobian = Eigen::MatrixXd::Zero(rows, q.size());
    Eigen::Index row = 0;
    for (const Constraint<double>& target : targets_) {
      const double scale = target.exact ? penalty : 1.0;
      const Vec3d at = kinematics.point(target.link, target.point);
      put(system.residual, row, 0, (at - target.place) * scale);
      if (target.exact) {
        const Mat3d turned = kinematics.link_rotation(target.link) * transpose(target.orientation);
        put(system.residual, row + 3, 0, rotation_vector(turned) * (0.1 * scale));
      }
      for (int d = 0; d < body_.dof_count(); ++d) {
        if (!body_.moves(d, target.link)) continue;
        const auto k = static_cast<std::size_t>(d);
        const Vec3d axis = kinematics.axis[k];
        put(system.jacobian, row, d, cross(axis, at - kinematics.origin[k]) * scale);
        if (target.exact) put(system.jacobian, row + 3, d, axis * (0.1 * scale));
      }
      row += target.exact ? 6 : 3;
    }
    return system;
  }

  template <class Matrix>
  static void put(Matrix& matrix, Eigen::Index row, Eigen::Index column, const Vec3d& v) {
    for (int i = 0; i < 3; ++i) matrix(row + i, column) = v[i];
  }

  const BodyModel& body_;
  std::vector<Constraint<double>> targets_;
  Eigen::Index goal_rows_ = 0;
  Eigen::VectorXd q_;
};

}  // namespace shigusa::testing_support
