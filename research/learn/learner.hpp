// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "measure.hpp"
#include "mixture.hpp"

namespace shigusa::bench {

struct LearnSettings {
  CriteriaSettings start = default_criteria();  // where the search begins
  int evaluations = 160;                        // mixtures that are measured
  double step = 0.12;   // standard deviation that the search begins with, of a gene
  bool scales = false;  // of the criteria that compare with people are searched too
  // Queries of some thousand motions: those of fewer differ by chance more than mixtures do.
  MeasureSettings measure{.motions = 2000};
};

// Settings with other random numbers for the queries than the search had.
[[nodiscard]] MeasureSettings other_seed(MeasureSettings settings);

// The mixture that CMA-ES finds for the training units: the best that it saw, or the middle of its
// last generation, which no chance has chosen, where that is better with other random numbers.
// Prints a line for each generation, with the loss of its best on what is held out.
[[nodiscard]] CriteriaSettings learned(const std::vector<Unit>& units,
                                       const LearnSettings& settings);

}  // namespace shigusa::bench
