// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/search.hpp>

namespace shigusa {

struct DifferentialEvolutionSettings {
  int evaluations = 1000;    // ≥ 1
  int population = 32;       // 4..10000
  double precision = 1e-12;  // convergence by the difference of a population's scores, ≥ 0
  std::uint64_t seed = 0;
};

// Differential evolution with self-adapting rates:
//
//   population := `population` uniformly random points, the first of all the problem's start
//   repeat, all of a generation scored in one call:
//     for each point x, with its own F and CR (each drawn anew with probability 0.1: F from 0.1..1,
//         CR from 0..1; at first 0.5 and 0.9):
//       v := x + F (b - x) + F (r - s), b one of the best tenth (2 at least), r and s two others
//       a coordinate of v beyond the cube goes half-way from x's to the face
//       trial := x with each coordinate of v by probability CR, and one for certain
//     a trial that scores no worse takes its x's place, and its F and CR stay
//   until the scores differ by `precision` at most; then with a new population again
//
// Storn and Price (J. Global Optimization 11, 1997) with the mutation current-to-pbest and the
// midpoint rule of JADE (Zhang and Sanderson, IEEE Trans. Evol. Comp. 13, 2009) and the adaptation
// of jDE (Brest et al., IEEE Trans. Evol. Comp. 10, 2006). Left out: JADE's archive and its means
// of successful rates, which differ little at some thousand evaluations; a shrinking population,
// since it has to know the budget.
//
// The final population is that of the last generation, in its order. Settings or a problem outside
// the stated ranges throw PreconditionError; exceptions of problem.evaluate pass through.
[[nodiscard]] SearchResult differential_evolution_search(
    const SearchProblem& problem, const DifferentialEvolutionSettings& settings,
    const Progress& progress = {});

}  // namespace shigusa
