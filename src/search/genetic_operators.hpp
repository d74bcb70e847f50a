// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/run.hpp>
#include <span>
#include <vector>

// The steps of genetic_search as separate functions. Bits are counted along the concatenated string
// of a genome: bit b lies in gene b / bits_per_gene, and bit 0 is the most significant of gene 0.
// Arguments outside the stated ranges throw PreconditionError.
namespace shigusa {

// A fixed-length string of small integers: (genes) each 0..2^bits_per_gene-1.
using Genome = std::vector<std::uint16_t>;

inline constexpr int kMaxBitsPerGene = 16;

// A genome, stored elsewhere, with its score.
struct ScoredGenome {
  const Genome* genes = nullptr;
  double score = 0.0;  // lower is better; +infinity for NaN
};

// The midpoints of the codes' shares of [0, 1]: (code + 0.5) / 2^bits_per_gene.
[[nodiscard]] std::vector<double> point_of_genome(const Genome& genome, int bits_per_gene);
// Appends the same to other points.
void append_point(const Genome& genome, int bits_per_gene, std::vector<double>& points);

// The codes of the shares that contain the coordinates, each in [0, 1].
[[nodiscard]] Genome genome_of_point(std::span<const double> point, int bits_per_gene);

// The fitness of a rejected individual, and the smallest there is, so that each can still be drawn.
inline constexpr double kLeastFitness = 1e-30;

// A genome with each gene uniform in 0..2^bits_per_gene-1.
[[nodiscard]] Genome random_genome(int genes, int bits_per_gene, Random& random);

// The numbers 0..count-1 in a uniformly random order (Fisher and Yates).
[[nodiscard]] std::vector<int> shuffled(int count, Random& random);

struct Children {
  Genome first;   // the first parent up to the cut, the second from there on
  Genome second;  // the opposite
};

// One-point crossover: exchanges the bits from bit `cut` on, 0 ≤ cut ≤ total bits.
[[nodiscard]] Children crossover(const Genome& a, const Genome& b, int cut, int bits_per_gene);

// The genome with one bit flipped, 0 ≤ bit < total bits.
[[nodiscard]] Genome with_bit_flipped(Genome genome, int bit, int bits_per_gene);

// The children of one generation: parents form pairs in a random order; each pair, with the given
// rate, has two children with the cut uniform in 1..total bits-1. Single-bit genomes cannot be cut
// and have no children. The number of parents is even.
[[nodiscard]] std::vector<Genome> children_of(std::span<const ScoredGenome> parents, double rate,
                                              int bits_per_gene, Random& random);

// The mutants of one generation: each parent, with the given rate, adds a copy of itself with one
// uniformly drawn bit flipped.
[[nodiscard]] std::vector<Genome> mutants_of(std::span<const ScoredGenome> parents, double rate,
                                             int bits_per_gene, Random& random);

// 1 / (offset + max(score, 0)), and at least kLeastFitness; offset > 0, score not NaN.
[[nodiscard]] double fitness(double score, double offset);

// Roulette without replacement: indices into `fitness` (each > 0), in the order drawn. Each draw
// takes one of the rest with probability proportional to its fitness; draws ≤ fitness.size().
[[nodiscard]] std::vector<int> roulette(std::span<const double> fitness, int draws, Random& random);

// Detects when the population, as a set, is unchanged for a number of generations.
class ConvergenceTest {
 public:
  explicit ConvergenceTest(int unchanged_generations) : needed_(unchanged_generations) {}

  // Tests convergence after the initial population and after each generation; the genomes must live
  // until the next call.
  [[nodiscard]] bool converged(std::span<const ScoredGenome> population);

 private:
  int needed_;
  int unchanged_ = -1;               // generations without change; before the first population, -1
  std::vector<const Genome*> last_;  // distinct, sorted
  std::vector<const Genome*> distinct_;  // of this generation
};

}  // namespace shigusa
