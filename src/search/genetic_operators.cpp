// SPDX-License-Identifier: MIT
#include "search/genetic_operators.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {
namespace {

int bit_count(const Genome& genome, int bits_per_gene) {
  return static_cast<int>(genome.size()) * bits_per_gene;
}

}  // namespace

void append_point(const Genome& genome, int bits_per_gene, std::vector<double>& points) {
  for (const std::uint16_t code : genome) points.push_back((code + 0.5) / (1 << bits_per_gene));
}

std::vector<double> point_of_genome(const Genome& genome, int bits_per_gene) {
  std::vector<double> point;
  point.reserve(genome.size());
  append_point(genome, bits_per_gene, point);
  return point;
}

Genome genome_of_point(std::span<const double> point, int bits_per_gene) {
  const int codes = 1 << bits_per_gene;
  Genome genome;
  genome.reserve(point.size());
  for (const double x : point) {
    SHG_CHECK(x >= 0.0 && x <= 1.0, "a coordinate outside of 0..1");
    // 1 belongs to the last share
    genome.push_back(static_cast<std::uint16_t>(std::min(static_cast<int>(x * codes), codes - 1)));
  }
  return genome;
}

Genome random_genome(int genes, int bits_per_gene, Random& random) {
  Genome genome(index(genes));
  for (auto& gene : genome) gene = static_cast<std::uint16_t>(random.below(1U << bits_per_gene));
  return genome;
}

std::vector<int> shuffled(int count, Random& random) {
  std::vector<int> order(index(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t left = order.size(); left > 1; --left) {
    std::swap(order[left - 1], order[random.below(static_cast<std::uint32_t>(left))]);
  }
  return order;
}

Children crossover(const Genome& a, const Genome& b, int cut, int bits_per_gene) {
  SHG_CHECK(a.size() == b.size(), "parents of different lengths");
  SHG_CHECK(cut >= 0 && cut <= bit_count(a, bits_per_gene), "cut outside of the bit string");
  const std::size_t cut_gene = index(cut / bits_per_gene);
  const int bits_exchanged_there = bits_per_gene - cut % bits_per_gene;
  Children children{a, b};
  for (std::size_t g = cut_gene; g < a.size(); ++g) {
    const std::uint32_t exchanged = g == cut_gene ? (1U << bits_exchanged_there) - 1U : ~0U;
    const std::uint32_t difference = (a[g] ^ b[g]) & exchanged;
    children.first[g] = static_cast<std::uint16_t>(a[g] ^ difference);
    children.second[g] = static_cast<std::uint16_t>(b[g] ^ difference);
  }
  return children;
}

Genome with_bit_flipped(Genome genome, int bit, int bits_per_gene) {
  SHG_CHECK(bit >= 0 && bit < bit_count(genome, bits_per_gene), "bit outside of the bit string");
  auto& gene = genome[index(bit / bits_per_gene)];
  const int significance = bits_per_gene - 1 - bit % bits_per_gene;
  gene = static_cast<std::uint16_t>(gene ^ (1U << significance));
  return genome;
}

std::vector<Genome> children_of(std::span<const ScoredGenome> parents, double rate,
                                int bits_per_gene, Random& random) {
  SHG_CHECK(parents.size() % 2 == 0, "an odd number of parents");
  std::vector<Genome> all;
  all.reserve(parents.size());
  const std::vector<int> order = shuffled(static_cast<int>(parents.size()), random);
  for (std::size_t i = 0; i + 1 < order.size(); i += 2) {
    const Genome& a = *parents[index(order[i])].genes;
    const Genome& b = *parents[index(order[i + 1])].genes;
    const int cuts = bit_count(a, bits_per_gene) - 1;
    if (cuts == 0 || !random.chance(rate)) continue;
    const int cut = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(cuts)));
    Children children = crossover(a, b, cut, bits_per_gene);
    all.push_back(std::move(children.first));
    all.push_back(std::move(children.second));
  }
  return all;
}

std::vector<Genome> mutants_of(std::span<const ScoredGenome> parents, double rate,
                               int bits_per_gene, Random& random) {
  std::vector<Genome> mutants;
  for (const ScoredGenome& parent : parents) {
    if (!random.chance(rate)) continue;
    const auto bits = static_cast<std::uint32_t>(bit_count(*parent.genes, bits_per_gene));
    const int bit = static_cast<int>(random.below(bits));
    mutants.push_back(with_bit_flipped(*parent.genes, bit, bits_per_gene));
  }
  return mutants;
}

double fitness(double score, double offset) {
  return std::max(kLeastFitness, 1.0 / (offset + std::max(score, 0.0)));
}

std::vector<int> roulette(std::span<const double> fitness, int draws, Random& random) {
  SHG_CHECK(draws <= static_cast<int>(fitness.size()), "more draws than individuals");
  std::vector<int> left(fitness.size());
  std::iota(left.begin(), left.end(), 0);
  const auto of = [&](int index) { return fitness[static_cast<std::size_t>(index)]; };
  std::vector<int> drawn;
  drawn.reserve(fitness.size());
  for (int d = 0; d < draws; ++d) {
    double total = 0.0;
    for (const int index : left) total += of(index);
    const double target = random.uniform() * total;
    // the last one takes any remainder of rounding
    auto chosen = left.begin();
    for (double sum = of(*chosen); sum <= target && chosen + 1 != left.end();) sum += of(*++chosen);
    drawn.push_back(*chosen);
    left.erase(chosen);
  }
  return drawn;
}

bool ConvergenceTest::converged(std::span<const ScoredGenome> population) {
  distinct_.clear();
  for (const ScoredGenome& individual : population) distinct_.push_back(individual.genes);
  const auto same = [](const Genome* a, const Genome* b) { return a == b || *a == *b; };
  std::sort(distinct_.begin(), distinct_.end(),
            [](const Genome* a, const Genome* b) { return a != b && *a < *b; });
  distinct_.erase(std::unique(distinct_.begin(), distinct_.end(), same), distinct_.end());
  const bool first = unchanged_ < 0;
  const bool unchanged =
      !first && std::equal(distinct_.begin(), distinct_.end(), last_.begin(), last_.end(), same);
  unchanged_ = unchanged ? unchanged_ + 1 : 0;
  std::swap(last_, distinct_);
  return unchanged_ >= needed_;
}

}  // namespace shigusa
