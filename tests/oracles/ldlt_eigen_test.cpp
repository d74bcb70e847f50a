// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <shigusa/run.hpp>

#include "math/ldlt.hpp"

namespace shigusa {
namespace {

constexpr int kMax = 24;
constexpr double kUnit = 1.1e-16;  // half a unit in the last place of 1

Eigen::MatrixXd random_matrix(int rows, int columns, Random& random) {
  Eigen::MatrixXd m(rows, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) m(i, j) = random.uniform(-1.0, 1.0);
  }
  return m;
}

Eigen::VectorXd solved(const Eigen::MatrixXd& a, Eigen::VectorXd b, double pivot_floor) {
  SmallSymmetric<double, kMax> small{};
  const int n = static_cast<int>(a.rows());
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) small(i, j) = a(i, j);
  }
  ldlt_solve(small, b.data(), n, pivot_floor);
  return b;
}

TEST(LdltAgainstEigen, DefiniteSystemsHaveTheSameSolution) {
  Random random(1);
  for (int n = 1; n <= kMax; ++n) {
    for (int trial = 0; trial < 50; ++trial) {
      const Eigen::MatrixXd j = random_matrix(n, n + 4, random);
      const Eigen::MatrixXd a = j * j.transpose();
      const Eigen::VectorXd b = random_matrix(n, 1, random);
      const Eigen::VectorXd expected = a.ldlt().solve(b);
      const double condition = a.norm() * a.inverse().norm();
      // both solve a system within some n units of A, which the condition number makes of x
      const double bound = 4.0 * n * kUnit * condition * (1.0 + expected.norm());
      ASSERT_LT((solved(a, b, 0.0) - expected).norm(), bound) << n;
    }
  }
}

// Rows of length near 1, each either new and well separated from the others or a sum of earlier
// ones.
Eigen::MatrixXd dependent_rows(int rows, Random& random) {
  Eigen::MatrixXd j = 0.1 * random_matrix(rows, rows + 4, random);
  for (int i = 0; i < rows; ++i) {
    j(i, i) += 1.0;
    if (i > 0 && random.chance(0.4)) {
      j.row(i) = random_matrix(1, i, random) * j.topRows(i) / std::sqrt(i);
    }
  }
  return j;
}

TEST(LdltAgainstEigen, RankDeficientSystemsGiveTheSameMotion) {
  // the multipliers y of J Jᵀ y = J e are not unique, but Jᵀ y is: the shortest way to J e
  Random random(2);
  constexpr int n = 12;
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::MatrixXd j = dependent_rows(n, random);
    const Eigen::VectorXd way = j * random_matrix(n + 4, 1, random);
    const Eigen::VectorXd multipliers = solved(j * j.transpose(), way, 1e-7);
    const auto decomposition = j.completeOrthogonalDecomposition();
    EXPECT_EQ((multipliers.array() != 0.0).count(), decomposition.rank());
    // y solves a system within n² units of J Jᵀ, whose condition number is that of J squared
    const double condition = j.norm() * decomposition.pseudoInverse().norm();
    const double bound =
        8.0 * n * n * kUnit * condition * condition * j.norm() * multipliers.norm();
    ASSERT_LT((j.transpose() * multipliers - decomposition.solve(way)).norm(), bound);
  }
}

}  // namespace
}  // namespace shigusa
