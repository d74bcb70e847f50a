// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <shigusa/core/progress.hpp>
#include <span>
#include <vector>

namespace shigusa {

// A fixed-length string of small integers: (genes) each 0..2^bits_per_gene-1.
using Genome = std::vector<std::uint16_t>;

inline constexpr int kMaxGenes = 10000;
inline constexpr int kMaxBitsPerGene = 16;

// A minimisation over genomes. Searches know numbers, never bodies; batch evaluation is the one
// seam between them and what is searched.
struct DiscreteProblem {
  int genes = 0;          // genes per genome, 1..kMaxGenes
  int bits_per_gene = 4;  // 1..kMaxBitsPerGene; a gene is an integer in 0..2^bits-1

  // Scores `count` genomes: `genomes` is (count × genes), `scores` is (count), lower is better.
  // A NaN score, or one left unwritten, is treated as the worst.
  std::function<void(std::span<const std::uint16_t> genomes, std::span<double> scores)> evaluate;
};

// A genome with its score.
struct Individual {
  Genome genes;
  double score = 0.0;  // lower is better; +infinity where the problem gave NaN

  friend bool operator==(const Individual&, const Individual&) = default;
};

enum class SearchEnd { converged, budget, cancelled };

// What a search returns.
struct SearchResult {
  std::vector<Individual> final_population;  // in the order of the last generation
  Individual best_seen;                      // the best of all evaluated; the first among equals
  int evaluations = 0;                       // genomes scored
  int rejected_nan = 0;                      // scores that were NaN
  int generations = 0;                       // completed after the initial population
  SearchEnd end = SearchEnd::budget;
};

}  // namespace shigusa
