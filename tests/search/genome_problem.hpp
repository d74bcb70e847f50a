// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "search/genetic.hpp"

// Problems over genomes, which the genetic algorithm decodes from points.
namespace shigusa::testing_support {

// A problem from a function that scores one genome.
template <class Score>
SearchProblem problem_of(int genes, int bits_per_gene, Score score) {
  const auto evaluate = [genes, bits_per_gene, score](std::span<const double> points,
                                                      std::span<double> scores) {
    const auto n = static_cast<std::size_t>(genes);
    ASSERT_EQ(points.size(), scores.size() * n);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i] = score(genome_of_point(points.subspan(i * n, n), bits_per_gene));
    }
  };
  return {.genes = genes, .evaluate = evaluate};
}

inline Genome genome_of(const Individual& individual, int bits_per_gene = kPaperBitsPerGene) {
  return genome_of_point(individual.point, bits_per_gene);
}

// Records the genomes of each call.
struct GenomeRecorder {
  std::vector<std::vector<Genome>> batches;

  // A copy of the problem that is watched.
  SearchProblem watch(SearchProblem problem, int bits_per_gene = kPaperBitsPerGene) {
    const auto inner = problem.evaluate;
    const auto genes = static_cast<std::size_t>(problem.genes);
    problem.evaluate = [this, inner, genes, bits_per_gene](std::span<const double> points,
                                                           std::span<double> scores) {
      batches.emplace_back();
      for (std::size_t i = 0; i < scores.size(); ++i) {
        batches.back().push_back(genome_of_point(points.subspan(i * genes, genes), bits_per_gene));
      }
      inner(points, scores);
    };
    return problem;
  }

  [[nodiscard]] std::vector<Genome> all() const {
    std::vector<Genome> genomes;
    for (const auto& batch : batches) genomes.insert(genomes.end(), batch.begin(), batch.end());
    return genomes;
  }
};

}  // namespace shigusa::testing_support
