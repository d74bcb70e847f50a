// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "measure.hpp"
#include "mixture.hpp"

namespace shigusa::bench {

struct LearnSettings {
  CriteriaSettings start = default_criteria();  // initial mixture of the search
  int evaluations = 160;                        // number of evaluated mixtures
  double step = 0.12;                           // initial standard deviation per gene
  bool scales = false;  // also searches the scales of criteria that compare with people
  // Queries with some thousand motions: with fewer, chance differences exceed those between
  // mixtures.
  MeasureSettings measure{.motions = 2000};
};

// Settings with other random numbers for the queries than the search had.
[[nodiscard]] MeasureSettings other_seed(MeasureSettings settings);

// The mixture that CMA-ES finds for the training units: the best evaluated one, or the mean of its
// last generation, which is free of selection bias, if that is better with other random numbers.
// Prints a line per generation, with the held-out loss of its best.
[[nodiscard]] CriteriaSettings learned(const std::vector<Unit>& units,
                                       const LearnSettings& settings);

}  // namespace shigusa::bench
