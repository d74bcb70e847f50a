// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/search.hpp>

namespace shigusa {

struct RandomSettings {
  int batch = 64;          // points scored in one call, 1..10000; does not affect the points
  int keep = 16;           // points of the final population, 1..10000
  int evaluations = 1000;  // ≥ 1
  std::uint64_t seed = 0;
};

// Uniformly random points, the baseline of every search:
//
//   score the start, if the problem has one, and then points drawn uniformly from the unit cube,
//   `batch` at a time
//
// The final population is the `keep` best, best first. J. Bergstra, Y. Bengio: Random search for
// hyper-parameter optimization, JMLR 13, 2012, explain why this is a better baseline than a grid.
// The result depends on problem and settings only; exceptions of problem.evaluate pass through, and
// settings or a problem out of range throw PreconditionError.
[[nodiscard]] SearchResult random_search(const SearchProblem& problem,
                                         const RandomSettings& settings,
                                         const Progress& progress = {});

}  // namespace shigusa
