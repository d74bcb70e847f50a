// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

#include "core/check.hpp"

#if defined(__clang__)
#define SHG_UNROLL _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
#define SHG_UNROLL _Pragma("GCC unroll 16")
#else
#define SHG_UNROLL
#endif

namespace shigusa {

// A symmetric matrix of up to Max rows, stored as its lower triangle, row by row. Each call states
// the number of rows in use.
template <class S, int Max>
struct SmallSymmetric {
  S lower[static_cast<unsigned>(Max * (Max + 1) / 2)];

  // Entry (i, j) with 0 ≤ j ≤ i < Max; the upper triangle is not stored.
  [[nodiscard]] S& operator()(int i, int j) { return lower[index(i, j)]; }
  [[nodiscard]] const S& operator()(int i, int j) const { return lower[index(i, j)]; }

 private:
  static int index(int i, int j) {
    SHG_ASSERT(0 <= j && j <= i && i < Max);
    return i * (i + 1) / 2 + j;
  }
};

// Factorises the leading n × n part of A in place: A = L D Lᵀ, L with a unit diagonal. On return
// a(i, j), j < i, holds L and a(i, i) holds 1 / D_i.
//
// A must be positive semi-definite, so that no pivoting is needed: if a pivot D_i vanishes, the
// rest of its column vanishes too. A pivot at or below `pivot_floor` (≥ 0, in the unit of A's
// diagonal) is stored as 1 / D_i = 0: row and column i are then dropped from A, separately in each
// lane of a pack S. Rows are processed in order: the last of several dependent rows is dropped. NaN
// stays NaN.
//
// Choosing the floor, for A = J Jᵀ and b = J e: a dropped row is left with an error of up to
// √pivot_floor |e|, so a low floor costs no accuracy. But where a pivot should be 0, rounding
// leaves up to about n · 1e-16 s² / d, with s the largest diagonal entry and d the smallest pivot
// kept: only a floor above √(n · 1e-16) s is sure to drop every dependent row.
//
// Source: Golub and Van Loan, Matrix Computations, chapter 4 (LDLᵀ without pivoting), by outer
// products: the operations after a pivot are independent of one another.
template <class S, int Max>
void ldlt_factorize(SmallSymmetric<S, Max>& a, int n, S pivot_floor) {
  SHG_ASSERT(0 <= n && n <= Max);
  for (int k = 0; k < n; ++k) {
    const S pivot = a(k, k);
    const auto dropped = pivot <= pivot_floor;
    const S inverse = select(dropped, S(0), S(1) / pivot);
    a(k, k) = inverse;
    // the next pivot first: its division takes longest
    for (int i = k + 1; i < n; ++i) {
      const S scaled = a(i, k);  // L_ik D_k
      a(i, k) = scaled * inverse;
      for (int j = k + 1; j <= i; ++j) a(i, j) = a(i, j) - scaled * a(j, k);
    }
  }
}

// Solves A x = b for the n numbers at `b`, in place, with the factors of ldlt_factorize in `a`.
// Components of dropped rows are 0; the others solve the equations that were kept.
template <class S, int Max>
void ldlt_substitute(const SmallSymmetric<S, Max>& a, S* b, int n) {
  for (int k = 0; k < n; ++k) {
    for (int i = k + 1; i < n; ++i) b[i] = b[i] - a(i, k) * b[k];
  }
  for (int i = 0; i < n; ++i) b[i] = b[i] * a(i, i);
  for (int k = n - 1; k > 0; --k) {
    for (int i = 0; i < k; ++i) b[i] = b[i] - a(k, i) * b[k];
  }
}

// Solves A x = b: the leading n × n part of `a` is replaced by its factors, the n numbers at `b` by
// the solution. If A is rank-deficient and b lies in its range (as J e does for A = J Jᵀ), x still
// solves all n equations; otherwise those of the dropped rows are left unsolved.
template <class S, int Max>
void ldlt_solve(SmallSymmetric<S, Max>& a, S* b, int n, S pivot_floor) {
  ldlt_factorize(a, n, pivot_floor);
  ldlt_substitute(a, b, n);
}

// The same for an n known to the compiler: in the same order of operations, with all loops
// unrolled, so that the system stays in registers where possible. `a` is unchanged.
template <int n, class S, int Max>
void ldlt_solve_fixed(const SmallSymmetric<S, Max>& a, S* b, S pivot_floor) {
  static_assert(0 < n && n <= Max && n <= 16);
  S l[static_cast<unsigned>(n * (n + 1) / 2)];
  S x[static_cast<unsigned>(n)];
  constexpr auto at = [](int i, int j) { return i * (i + 1) / 2 + j; };
  // the rest of A before step k: nothing is copied beforehand
  const auto left = [&](int i, int j, int k) -> const S& {
    return k == 0 ? a.lower[at(i, j)] : l[at(i, j)];
  };
  SHG_UNROLL for (int i = 0; i < n; ++i) x[i] = b[i];
  SHG_UNROLL for (int k = 0; k < n; ++k) {
    const S pivot = left(k, k, k);
    const auto dropped = pivot <= pivot_floor;
    const S inverse = select(dropped, S(0), S(1) / pivot);
    l[at(k, k)] = inverse;
    SHG_UNROLL for (int i = k + 1; i < n; ++i) {
      const S scaled = left(i, k, k);
      l[at(i, k)] = scaled * inverse;
      SHG_UNROLL for (int j = k + 1; j <= i; ++j) {
        l[at(i, j)] = left(i, j, k) - scaled * l[at(j, k)];
      }
      x[i] = x[i] - l[at(i, k)] * x[k];
    }
  }
  SHG_UNROLL for (int i = 0; i < n; ++i) x[i] = x[i] * l[at(i, i)];
  SHG_UNROLL for (int k = n - 1; k > 0; --k) {
    SHG_UNROLL for (int i = 0; i < k; ++i) x[i] = x[i] - l[at(k, i)] * x[k];
  }
  SHG_UNROLL for (int i = 0; i < n; ++i) b[i] = x[i];
}

#undef SHG_UNROLL

}  // namespace shigusa
