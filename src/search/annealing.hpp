// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/search.hpp>

namespace shigusa {

struct AnnealingSettings {
  int evaluations = 1000;    // ≥ 1
  int chains = 16;           // run in parallel, 2..10000
  int first_cycle = 32;      // steps of the first cooling, 1..1000000
  double first_step = 0.3;   // standard deviation of a move when hot, 1e-6..1
  double last_step = 0.003;  // the same when cold, 1e-6..first_step
  double hot = 0.05;  // temperature when hot, relative to the spread of random scores, 1e-6..1e6
  double cooling = 1e-4;  // temperature when cold relative to hot, 1e-12..1
  std::uint64_t seed = 0;
};

// Simulated annealing, with several chains in parallel so that a batch fills vector registers:
//
//   chains := uniformly random points, the first of all the problem's start
//   T_hot := hot · the spread of the middle half of their scores
//   for cycles of first_cycle, 2 first_cycle, 4 first_cycle, … steps:
//     for each step, at a share f (0..1) of the cycle, all chains scored in one call:
//       T := T_hot · cooling^f;  width := first_step · (last_step / first_step)^f
//       move: each coordinate with probability 3 / genes, and one for certain, by a normal deviate
//         of that width, mirrored at the faces
//       a move that scores lower is taken, another with probability exp(-increase / T)
//     every second chain goes on from the best point seen
//
// S. Kirkpatrick, C. D. Gelatt, M. P. Vecchi: Optimization by simulated annealing, Science 220,
// 1983; the paper names it as future work (section 5). Cycles of doubling length replace a single
// cooling, which would depend on the budget. Left out: a temperature that adapts to the acceptance
// rate, and exchange of states between chains of different temperatures.
//
// The final population is the best point of each chain, in their order. Settings or a problem
// outside the stated ranges throw PreconditionError; exceptions of problem.evaluate pass through.
[[nodiscard]] SearchResult annealing_search(const SearchProblem& problem,
                                            const AnnealingSettings& settings,
                                            const Progress& progress = {});

}  // namespace shigusa
