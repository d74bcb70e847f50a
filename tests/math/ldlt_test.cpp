// SPDX-License-Identifier: MIT
#include "math/ldlt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <shigusa/run.hpp>
#include <vector>

namespace shigusa {
namespace {

constexpr int kMax = 12;
using Matrix = SmallSymmetric<double, kMax>;
using Vector = std::vector<double>;

// J (rows × columns), entries uniform in [-1, 1]
std::vector<Vector> random_rows(int rows, int columns, Random& random) {
  std::vector<Vector> j(static_cast<std::size_t>(rows), Vector(static_cast<std::size_t>(columns)));
  for (Vector& row : j) {
    for (double& entry : row) entry = random.uniform(-1.0, 1.0);
  }
  return j;
}

// J Jᵀ: almost surely of rank min(rows, columns)
Matrix gram(const std::vector<Vector>& j) {
  Matrix a{};
  for (std::size_t row = 0; row < j.size(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      double sum = 0.0;
      for (std::size_t k = 0; k < j[row].size(); ++k) sum += j[row][k] * j[column][k];
      a(static_cast<int>(row), static_cast<int>(column)) = sum;
    }
  }
  return a;
}

Vector times(const Matrix& a, const Vector& x) {
  const int n = static_cast<int>(x.size());
  Vector product(x.size());
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double entry = i >= j ? a(i, j) : a(j, i);
      product[static_cast<std::size_t>(i)] += entry * x[static_cast<std::size_t>(j)];
    }
  }
  return product;
}

Vector solved(Matrix a, Vector b, double pivot_floor = 1e-10) {
  ldlt_solve(a, b.data(), static_cast<int>(b.size()), pivot_floor);
  return b;
}

double largest_difference(const Vector& a, const Vector& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::fmax(largest, std::fabs(a[i] - b[i]));
  return largest;
}

// LDLᵀ of a positive definite A solves a nearby system, |ΔA| ≤ 8 n (n + 2) u |A| or so: with n ≤
// 12, entries of A up to 12 and x up to 1, the residual is below 12 · 12 · 1400 · 1.1e-16.
constexpr double kResidualBound = 3e-11;

TEST(Ldlt, SolvesOneEquation) {
  Matrix a{};
  a(0, 0) = 4.0;
  EXPECT_EQ(solved(a, {3.0}), (Vector{0.75}));
}

TEST(Ldlt, SolvesThreeByHand) {
  Matrix a{};
  a(0, 0) = 4.0;
  a(1, 0) = 2.0;
  a(1, 1) = 5.0;
  a(2, 0) = -2.0;
  a(2, 1) = 1.0;
  a(2, 2) = 6.0;
  // x = (1, 2, 3); all steps are exact: the pivots are 4, 4, 4
  EXPECT_EQ(solved(a, {2.0, 15.0, 18.0}), (Vector{1.0, 2.0, 3.0}));
}

TEST(Ldlt, OfNoEquationsDoesNothing) { EXPECT_EQ(solved(Matrix{}, {}), Vector{}); }

TEST(Ldlt, LeavesRowsBeyondNAlone) {
  Matrix a{};
  a(0, 0) = 2.0;
  a(1, 0) = 7.0;
  a(1, 1) = 9.0;
  double b[] = {1.0, 5.0};
  ldlt_solve(a, b, 1, 0.0);
  EXPECT_EQ(b[0], 0.5);
  EXPECT_EQ(b[1], 5.0);
  EXPECT_EQ(a(1, 0), 7.0);
  EXPECT_EQ(a(1, 1), 9.0);
}

TEST(Ldlt, SolvesDefiniteSystems) {
  Random random(1);
  for (int n = 1; n <= kMax; ++n) {
    for (int trial = 0; trial < 200; ++trial) {
      Matrix a = gram(random_rows(n, n, random));
      for (int i = 0; i < n; ++i) a(i, i) += 0.1;
      const Vector x = random_rows(1, n, random)[0];
      const Vector b = times(a, x);
      ASSERT_LT(largest_difference(times(a, solved(a, b)), b), kResidualBound);
      // the smallest eigenvalue is at least 0.1, so the error at most ten residuals by √n
      ASSERT_LT(largest_difference(solved(a, b), x), kResidualBound * 10.0 * std::sqrt(kMax));
    }
  }
}

TEST(Ldlt, FactorsMultiplyToTheMatrix) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix a = gram(random_rows(kMax, kMax + 3, random));
    Matrix f = a;
    ldlt_factorize(f, kMax, 0.0);
    for (int i = 0; i < kMax; ++i) {
      for (int j = 0; j <= i; ++j) {
        double sum = (i == j ? 1.0 : f(i, j)) / f(j, j);
        for (int k = 0; k < j; ++k) sum += f(i, k) * f(j, k) / f(k, k);
        // each entry is a sum of up to n products that |A| bounds
        ASSERT_NEAR(sum, a(i, j), 1e-13);
      }
    }
  }
}

TEST(Ldlt, FactorsServeSeveralRightSides) {
  Random random(3);
  const Matrix a = gram(random_rows(6, 9, random));
  Matrix factors = a;
  ldlt_factorize(factors, 6, 1e-10);
  for (int trial = 0; trial < 10; ++trial) {
    const Vector b = random_rows(1, 6, random)[0];
    Vector x = b;
    ldlt_substitute(factors, x.data(), 6);
    EXPECT_EQ(x, solved(a, b));
  }
}

TEST(Ldlt, DroppedRowsAreLeftUnsolvedByAtMostTheRootOfTheFloor) {
  Random random(4);
  for (const double pivot_floor : {1e-4, 1e-6, 1e-8}) {
    for (int rank = 1; rank < kMax; ++rank) {
      for (int trial = 0; trial < 100; ++trial) {
        const auto j = random_rows(kMax, rank, random);
        const Vector e = random_rows(1, rank, random)[0];
        Vector b(static_cast<std::size_t>(kMax));
        for (std::size_t i = 0; i < b.size(); ++i) {
          for (std::size_t k = 0; k < e.size(); ++k) b[i] += j[i][k] * e[k];
        }
        const Matrix a = gram(j);
        const Vector x = solved(a, b, pivot_floor);
        // |e| ≤ √rank; the kept equations add their own residual, for multipliers of up to |e| / √d
        const double root = std::sqrt(pivot_floor);
        const double bound = std::sqrt(rank) * (root + kResidualBound / root);
        ASSERT_LT(largest_difference(times(a, x), b), bound) << rank;
      }
    }
  }
}

TEST(Ldlt, AsManyRowsDropOutAsTheRankLacks) {
  Random random(5);
  const double pivot_floor = std::sqrt(kMax * 1.1e-16) * kMax;  // no diagonal entry is above kMax
  for (int rank = 0; rank <= kMax; ++rank) {
    for (int trial = 0; trial < 100; ++trial) {
      const Vector x = solved(gram(random_rows(kMax, rank, random)),
                              Vector(static_cast<std::size_t>(kMax), 1.0), pivot_floor);
      ASSERT_EQ(std::count(x.begin(), x.end(), 0.0), kMax - rank);
    }
  }
}

TEST(Ldlt, DroppedRowsAreAsIfDeleted) {
  // row 1 is row 0 again; without it the system is [4 2; 2 5]
  Matrix a{};
  a(0, 0) = a(1, 0) = a(1, 1) = 4.0;
  a(2, 0) = a(2, 1) = 2.0;
  a(2, 2) = 5.0;
  Matrix reduced{};
  reduced(0, 0) = 4.0;
  reduced(1, 0) = 2.0;
  reduced(1, 1) = 5.0;
  const Vector whole = solved(a, {1.0, -7.0, 3.0});
  const Vector rest = solved(reduced, {1.0, 3.0});
  EXPECT_EQ(whole, (Vector{rest[0], 0.0, rest[1]}));
}

TEST(Ldlt, WeakRowsDropOutEvenIfTheirColumnIsNotZero) {
  Matrix a{};
  a(0, 0) = 1e-6;
  a(1, 0) = 1e-4;
  a(1, 1) = 2.0;
  EXPECT_EQ(solved(a, {1.0, 1.0}, 1e-5), (Vector{0.0, 0.5}));
}

TEST(Ldlt, ThePivotFloorItselfDropsOut) {
  Matrix a{};
  a(0, 0) = 0.5;
  EXPECT_EQ(solved(a, {1.0}, 0.5), (Vector{0.0}));
  EXPECT_EQ(solved(a, {1.0}, 0.49), (Vector{2.0}));
}

TEST(Ldlt, NullMatrixGivesZeroEvenAtAFloorOfZero) {
  EXPECT_EQ(solved(Matrix{}, {1.0, 2.0, 3.0}, 0.0), (Vector{0.0, 0.0, 0.0}));
}

TEST(Ldlt, NegativePivotsDropOut) {
  Matrix a{};
  a(0, 0) = -1e-17;  // a 0 with rounding
  a(1, 1) = 2.0;
  EXPECT_EQ(solved(a, {1.0, 1.0}, 0.0), (Vector{0.0, 0.5}));
}

TEST(Ldlt, PassesNaNOn) {
  Matrix a{};
  a(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(solved(a, {1.0})[0]));
}

// The smallest pack: the operations that ldlt.hpp requires of a scalar.
struct Two {
  double first = 0.0;
  double second = 0.0;
  Two() = default;
  explicit Two(double both) : first(both), second(both) {}
  Two(double a, double b) : first(a), second(b) {}
  friend Two operator-(Two a, Two b) { return {a.first - b.first, a.second - b.second}; }
  friend Two operator*(Two a, Two b) { return {a.first * b.first, a.second * b.second}; }
  friend Two operator/(Two a, Two b) { return {a.first / b.first, a.second / b.second}; }
  struct Mask {
    bool first, second;
  };
  friend Mask operator<=(Two a, Two b) { return {a.first <= b.first, a.second <= b.second}; }
  friend Two select(Mask condition, Two yes, Two no) {
    return {condition.first ? yes.first : no.first, condition.second ? yes.second : no.second};
  }
};

TEST(Ldlt, LanesOfAPackAreSolvedEachOnItsOwn) {
  Random random(6);
  constexpr int n = 7;
  for (int trial = 0; trial < 500; ++trial) {
    // the lanes differ in rank
    const Matrix first = gram(random_rows(n, 1 + static_cast<int>(random.below(n)), random));
    const Matrix second = gram(random_rows(n, 1 + static_cast<int>(random.below(n)), random));
    const Vector b = random_rows(1, n, random)[0];
    SmallSymmetric<Two, kMax> a;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j) a(i, j) = Two(first(i, j), second(i, j));
    }
    Two x[n];
    for (int i = 0; i < n; ++i) x[i] = Two(b[static_cast<std::size_t>(i)]);
    ldlt_solve(a, x, n, Two(1e-10));
    const Vector alone_first = solved(first, b);
    const Vector alone_second = solved(second, b);
    for (int i = 0; i < n; ++i) {
      ASSERT_EQ(x[i].first, alone_first[static_cast<std::size_t>(i)]);
      ASSERT_EQ(x[i].second, alone_second[static_cast<std::size_t>(i)]);
    }
  }
}

// ldlt_solve_fixed<n> compared with ldlt_solve, on systems of every rank.
template <int n>
void expect_fixed_gives_the_same_bits(double pivot_floor) {
  Random random(70 + n);
  for (int trial = 0; trial < 300; ++trial) {
    const int rank = 1 + static_cast<int>(random.below(n + 3));
    const Matrix a = gram(random_rows(n, rank, random));
    Matrix kept = a;
    Vector x = random_rows(1, n, random)[0];
    const Vector expected = solved(a, x, pivot_floor);
    ldlt_solve_fixed<n>(kept, x.data(), pivot_floor);
    ASSERT_EQ(x, expected) << n << " rows of rank " << rank;
    ASSERT_TRUE(std::equal(std::begin(a.lower), std::end(a.lower), std::begin(kept.lower)));
  }
}

TEST(LdltFixed, GivesTheSameBitsAsOfAnySizeAndLeavesTheMatrix) {
  for (const double pivot_floor : {0.0, 1e-10, 1e-3}) {
    expect_fixed_gives_the_same_bits<1>(pivot_floor);
    expect_fixed_gives_the_same_bits<2>(pivot_floor);
    expect_fixed_gives_the_same_bits<3>(pivot_floor);
    expect_fixed_gives_the_same_bits<6>(pivot_floor);
    expect_fixed_gives_the_same_bits<9>(pivot_floor);
    expect_fixed_gives_the_same_bits<12>(pivot_floor);
  }
}

TEST(LdltFixed, LeavesNumbersBeyondNAlone) {
  Matrix a{};
  a(0, 0) = 2.0;
  double b[] = {1.0, 5.0};
  ldlt_solve_fixed<1>(a, b, 0.0);
  EXPECT_EQ(b[0], 0.5);
  EXPECT_EQ(b[1], 5.0);
}

TEST(LdltFixed, PassesNaNOn) {
  Matrix a{};
  a(0, 0) = std::numeric_limits<double>::quiet_NaN();
  double b[] = {1.0};
  ldlt_solve_fixed<1>(a, b, 0.0);
  EXPECT_TRUE(std::isnan(b[0]));
}

}  // namespace
}  // namespace shigusa
