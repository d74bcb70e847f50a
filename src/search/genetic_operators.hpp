// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/run.hpp>
#include <span>
#include <vector>

// The steps of genetic_search, each on its own. Bits are counted along the concatenated string of a
// genome: bit b lies in gene b / bits_per_gene, and bit 0 is the most significant of gene 0. What
// lies outside the stated ranges throws PreconditionError.
namespace shigusa {

// A fixed-length string of small integers: (genes) each 0..2^bits_per_gene-1.
using Genome = std::vector<std::uint16_t>;

inline constexpr int kMaxBitsPerGene = 16;

// A genome, which lives elsewhere, with its score.
struct ScoredGenome {
  const Genome* genes = nullptr;
  double score = 0.0;  // lower is better; +infinity where the problem gave NaN
};

// A gene's code stands for the middle of its share of [0, 1]: (code + 0.5) / 2^bits_per_gene.
[[nodiscard]] std::vector<double> point_of_genome(const Genome& genome, int bits_per_gene);
// The same behind other points.
void append_point(const Genome& genome, int bits_per_gene, std::vector<double>& points);

// The codes whose shares the coordinates, each in [0, 1], lie in.
[[nodiscard]] Genome genome_of_point(std::span<const double> point, int bits_per_gene);

// The fitness of a rejected individual; no fitness is smaller, so that each can still be drawn.
inline constexpr double kLeastFitness = 1e-30;

// Each gene uniform in 0..2^bits_per_gene-1.
[[nodiscard]] Genome random_genome(int genes, int bits_per_gene, Random& random);

// The numbers 0..count-1 in an order drawn uniformly from all (Fisher and Yates).
[[nodiscard]] std::vector<int> shuffled(int count, Random& random);

struct Children {
  Genome first;   // the first parent up to the cut, the second from there on
  Genome second;  // the other way round
};

// One-point crossover: exchanges the bits from bit `cut` on, 0 ≤ cut ≤ total bits.
[[nodiscard]] Children crossover(const Genome& a, const Genome& b, int cut, int bits_per_gene);

// The genome with one bit flipped, 0 ≤ bit < total bits.
[[nodiscard]] Genome with_bit_flipped(Genome genome, int bit, int bits_per_gene);

// The children of one generation: parents in a random order form pairs; each pair, with the given
// rate, has two children with the cut uniform in 1..total bits-1. Single-bit genomes cannot be cut
// and have none. The number of parents is even.
[[nodiscard]] std::vector<Genome> children_of(std::span<const ScoredGenome> parents, double rate,
                                              int bits_per_gene, Random& random);

// The mutants of one generation: each parent, with the given rate, adds a copy of itself with one
// bit, drawn uniformly, flipped.
[[nodiscard]] std::vector<Genome> mutants_of(std::span<const ScoredGenome> parents, double rate,
                                             int bits_per_gene, Random& random);

// 1 / (offset + max(score, 0)), and at least kLeastFitness; offset > 0, score not NaN.
[[nodiscard]] double fitness(double score, double offset);

// Roulette without replacement: indices into `fitness` (each > 0), in the order drawn. Each draw
// takes one of those left with probability proportional to its fitness; draws ≤ fitness.size().
[[nodiscard]] std::vector<int> roulette(std::span<const double> fitness, int draws, Random& random);

// Tells when the population, as a set, has stayed the same for a number of generations.
class ConvergenceTest {
 public:
  explicit ConvergenceTest(int unchanged_generations) : needed_(unchanged_generations) {}

  // To be called with the initial population and then after each generation, whose genomes are to
  // live until the next call.
  [[nodiscard]] bool converged(std::span<const ScoredGenome> population);

 private:
  int needed_;
  int unchanged_ = -1;               // generations without change; before the first population, -1
  std::vector<const Genome*> last_;  // distinct, in their order
  std::vector<const Genome*> distinct_;  // of this generation
};

}  // namespace shigusa
