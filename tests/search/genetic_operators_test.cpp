// SPDX-License-Identifier: MIT
#include "search/genetic_operators.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <map>
#include <shigusa/search.hpp>
#include <string>

#include "core/check.hpp"
#include "core/statistics.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The concatenated bit string, as the paper describes it: the oracle for the operators.
std::string bits_of(const Genome& genome, int bits_per_gene) {
  std::string bits;
  for (const auto gene : genome) {
    for (int bit = bits_per_gene - 1; bit >= 0; --bit) bits += ((gene >> bit) & 1) != 0 ? '1' : '0';
  }
  return bits;
}

std::vector<ScoredGenome> individuals(const std::vector<Genome>& genomes) {
  static std::deque<Genome> kept;
  std::vector<ScoredGenome> all;
  for (const Genome& genome : genomes) all.push_back({&kept.emplace_back(genome), 0.0});
  return all;
}

struct Pair {
  int bits_per_gene;
  Genome a;
  Genome b;
};

Pair arbitrary_pair() {
  const int bits = *rc::gen::inRange(1, kMaxBitsPerGene + 1);
  const auto genes = *rc::gen::inRange<std::size_t>(1, 12);
  const auto gene = rc::gen::map(rc::gen::inRange(0, 1 << bits),
                                 [](int value) { return static_cast<std::uint16_t>(value); });
  const auto genome = rc::gen::container<Genome>(genes, gene);
  return {bits, *genome, *genome};
}

RC_GTEST_PROP(Crossover, ExchangesTheBitStringsFromTheCutOn, ()) {
  const Pair p = arbitrary_pair();
  const std::string a = bits_of(p.a, p.bits_per_gene);
  const std::string b = bits_of(p.b, p.bits_per_gene);
  const auto cut = *rc::gen::inRange<std::size_t>(0, a.size() + 1);
  const Children children = crossover(p.a, p.b, static_cast<int>(cut), p.bits_per_gene);
  RC_ASSERT(bits_of(children.first, p.bits_per_gene) == a.substr(0, cut) + b.substr(cut));
  RC_ASSERT(bits_of(children.second, p.bits_per_gene) == b.substr(0, cut) + a.substr(cut));
}

RC_GTEST_PROP(PointOfGenome, IsTheMiddleOfTheSharesAndGoesBack, ()) {
  const Pair p = arbitrary_pair();
  const std::vector<double> point = point_of_genome(p.a, p.bits_per_gene);
  for (std::size_t g = 0; g < p.a.size(); ++g) {
    RC_ASSERT(point[g] * (1 << p.bits_per_gene) == p.a[g] + 0.5);
  }
  RC_ASSERT(genome_of_point(point, p.bits_per_gene) == p.a);
}

TEST(GenomeOfPoint, SharesAreHalfOpenButForTheLast) {
  const std::vector<double> point{0.0, 0.0625, 0.0624999, 0.9375, 1.0};
  EXPECT_EQ(genome_of_point(point, 4), (Genome{0, 1, 0, 15, 15}));
}

TEST(GenomeOfPoint, RefusesWhatIsOutsideOfTheCube) {
  for (const double x : {-1e-9, 1.0 + 1e-9, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)genome_of_point(std::vector<double>{x}, 4), PreconditionError);
  }
}

RC_GTEST_PROP(WithBitFlipped, FlipsThatBitOfTheStringOnly, ()) {
  const Pair p = arbitrary_pair();
  std::string expected = bits_of(p.a, p.bits_per_gene);
  const auto bit = *rc::gen::inRange<std::size_t>(0, expected.size());
  expected[bit] = expected[bit] == '0' ? '1' : '0';
  const Genome flipped = with_bit_flipped(p.a, static_cast<int>(bit), p.bits_per_gene);
  RC_ASSERT(bits_of(flipped, p.bits_per_gene) == expected);
}

TEST(RandomGenome, HasEachValueEquallyOftenInEachGene) {
  constexpr std::size_t genes = 8;
  std::array<std::vector<int>, genes> counts;
  counts.fill(std::vector<int>(16));
  Random random(1);
  for (int i = 0; i < 16000; ++i) {
    const Genome genome = random_genome(genes, 4, random);
    for (std::size_t g = 0; g < genes; ++g) ++counts[g].at(genome[g]);
  }
  for (const auto& of_gene : counts) {
    EXPECT_LT(chi_square_uniform(of_gene), chi_square_limit(15));
  }
}

TEST(RandomGenome, GenesAreIndependent) {
  std::vector<int> pairs(256);
  Random random(2);
  for (int i = 0; i < 51200; ++i) {
    const Genome genome = random_genome(2, 4, random);
    ++pairs[static_cast<std::size_t>(genome[0] * 16 + genome[1])];
  }
  EXPECT_LT(chi_square_uniform(pairs), chi_square_limit(255));
}

TEST(RandomGenome, UsesAllOfSixteenBits) {
  Random random(3);
  int low = 0xFFFF;
  int high = 0;
  for (const int gene : random_genome(kMaxGenes, kMaxBitsPerGene, random)) {
    low = std::min(low, gene);
    high = std::max(high, gene);
  }
  // each end is missed by 10 000 genes with probability (1 - 2^-9)^10000 = 3e-9
  EXPECT_LT(low, 1 << 7);
  EXPECT_GE(high, (1 << 16) - (1 << 7));
}

TEST(Shuffled, HasEachOrderEquallyOften) {
  std::map<std::vector<int>, int> orders;
  Random random(4);
  for (int i = 0; i < 24000; ++i) ++orders[shuffled(4, random)];
  ASSERT_EQ(orders.size(), 24U);
  std::vector<int> counts;
  for (const auto& [order, count] : orders) counts.push_back(count);
  EXPECT_LT(chi_square_uniform(counts), chi_square_limit(23));
  EXPECT_TRUE(shuffled(0, random).empty());
}

// A child of parents of zeros and of ones shows the cut.
TEST(ChildrenOf, CutIsUniformOverTheGapsBetweenBits) {
  constexpr int bits = 8 * 4;
  const auto parents = individuals({Genome(8, 0x0), Genome(8, 0xF)});
  std::vector<int> counts(bits);
  Random random(6);
  for (int i = 0; i < 31000; ++i) {
    const auto children = children_of(parents, 1.0, 4, random);
    ASSERT_EQ(children.size(), 2U);
    const std::string child = bits_of(children[0], 4);
    const auto cut = std::min(child.find_first_not_of(child[0]), child.size());
    // complements of each other, with one change from zeros to ones or back
    ASSERT_EQ(child.find(child[0], cut), std::string::npos);
    ASSERT_LT(cut, static_cast<std::size_t>(bits));
    ++counts[cut];
  }
  EXPECT_EQ(counts[0], 0);  // neither end of the string is a cut
  counts.erase(counts.begin());
  EXPECT_LT(chi_square_uniform(counts), chi_square_limit(bits - 2));
}

TEST(ChildrenOf, NumberOfPairsWithChildrenIsBinomial) {
  const auto parents = individuals(std::vector<Genome>(8, Genome(8, 0)));
  std::vector<int> counts(5);
  Random random(7);
  constexpr int generations = 16000;
  for (int i = 0; i < generations; ++i) {
    const std::size_t children = children_of(parents, 0.5, 4, random).size();
    ASSERT_EQ(children % 2, 0U);
    ++counts.at(children / 2);
  }
  EXPECT_LT(chi_square(counts, {1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0}),
            chi_square_limit(4));
}

TEST(ChildrenOf, RateZeroGivesNoneAndRateOneTwoForEachPair) {
  const auto parents = individuals(std::vector<Genome>(8, Genome(8, 0)));
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(children_of(parents, 0.0, 4, random).empty());
    EXPECT_EQ(children_of(parents, 1.0, 4, random).size(), 8U);
  }
}

TEST(ChildrenOf, EachParentIsInOnePairAndEachPairingEquallyLikely) {
  // parents are one-hot: the bitwise sum of two children identifies their parents
  const auto parents = individuals({{1}, {2}, {4}, {8}});
  std::map<int, int> partners_of_first;
  Random random(9);
  for (int i = 0; i < 12000; ++i) {
    const auto children = children_of(parents, 1.0, 4, random);
    ASSERT_EQ(children.size(), 4U);
    const int one = children[0][0] + children[1][0];
    const int other = children[2][0] + children[3][0];
    ASSERT_EQ(one + other, 15);
    ++partners_of_first[((one & 1) != 0 ? one : other) - 1];
  }
  ASSERT_EQ(partners_of_first.size(), 3U);
  EXPECT_LT(chi_square_uniform(
                {partners_of_first.at(2), partners_of_first.at(4), partners_of_first.at(8)}),
            chi_square_limit(2));
}

TEST(ChildrenOf, SingleBitsCannotBeCut) {
  Random random(10);
  EXPECT_TRUE(children_of(individuals({{0}, {1}}), 1.0, 1, random).empty());
}

TEST(MutantsOf, EachParentMutatesAtTheRate) {
  constexpr int generations = 20000;
  const auto parents = individuals({Genome(8, 0x0), Genome(8, 0xF), Genome(8, 0xA)});
  std::array<int, 3> counts{};
  Random random(11);
  for (int i = 0; i < generations; ++i) {
    for (const Genome& mutant : mutants_of(parents, 0.1, 4, random)) {
      // nearest to one of the three, which differ in 16 bits and more
      const auto ones = bits_of(mutant, 4);
      const auto set = std::count(ones.begin(), ones.end(), '1');
      ++counts[set <= 1 ? 0U : set >= 31 ? 1U : 2U];
    }
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, 0.1 * generations, binomial_tolerance(generations, 0.1));
  }
}

TEST(MutantsOf, NumberOfMutantsIsBinomial) {
  const auto parents = individuals(std::vector<Genome>(2, Genome(8, 0)));
  std::vector<int> counts(3);
  Random random(12);
  for (int i = 0; i < 20000; ++i) ++counts.at(mutants_of(parents, 0.1, 4, random).size());
  EXPECT_LT(chi_square(counts, {0.81, 0.18, 0.01}), chi_square_limit(2));
}

TEST(MutantsOf, OneBitIsFlippedUniformly) {
  constexpr std::size_t bits = 8 * 4;
  const auto parents = individuals(std::vector<Genome>(1, Genome(8, 0)));
  std::vector<int> counts(bits);
  Random random(13);
  for (int i = 0; i < 32000; ++i) {
    const auto mutants = mutants_of(parents, 1.0, 4, random);
    ASSERT_EQ(mutants.size(), 1U);
    const std::string mutant = bits_of(mutants[0], 4);
    ASSERT_EQ(std::count(mutant.begin(), mutant.end(), '1'), 1);
    ++counts[mutant.find('1')];
  }
  EXPECT_LT(chi_square_uniform(counts), chi_square_limit(bits - 1));
}

TEST(MutantsOf, RateZeroGivesNone) {
  const auto parents = individuals(std::vector<Genome>(8, Genome(8, 0)));
  Random random(14);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(mutants_of(parents, 0.0, 4, random).empty());
}

TEST(Fitness, IsOneOverOffsetPlusScore) {
  EXPECT_EQ(fitness(0.0, 0.05), 20.0);
  EXPECT_EQ(fitness(0.45, 0.05), 2.0);
}

TEST(Fitness, TakesANegativeScoreForZero) {
  EXPECT_EQ(fitness(-1.0, 0.05), fitness(0.0, 0.05));
  EXPECT_EQ(fitness(-kInfinity, 0.05), fitness(0.0, 0.05));
}

TEST(Fitness, OfTheWorstScoreIsTheLeastAndPositive) {
  EXPECT_EQ(fitness(kInfinity, 0.05), kLeastFitness);
  EXPECT_EQ(fitness(1e300, 0.05), kLeastFitness);
  EXPECT_GT(kLeastFitness, 0.0);
}

const std::vector<double> kFitness = {1.0, 2.0, 3.0, 4.0};

TEST(Roulette, FirstDrawIsProportionalToFitness) {
  std::vector<int> counts(4);
  Random random(15);
  for (int i = 0; i < 20000; ++i) {
    ++counts[static_cast<std::size_t>(roulette(kFitness, 1, random)[0])];
  }
  EXPECT_LT(chi_square(counts, {0.1, 0.2, 0.3, 0.4}), chi_square_limit(3));
}

TEST(Roulette, SecondDrawIsProportionalAmongThoseLeft) {
  // P(i, then j) = f_i / F · f_j / (F - f_i)
  std::vector<int> counts;
  std::vector<double> probabilities;
  std::map<std::vector<int>, std::size_t> index;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      index[{i, j}] = probabilities.size();
      const double first = kFitness[static_cast<std::size_t>(i)];
      const double second = kFitness[static_cast<std::size_t>(j)];
      probabilities.push_back(first / 10.0 * second / (10.0 - first));
    }
  }
  counts.resize(probabilities.size());
  Random random(16);
  for (int i = 0; i < 50000; ++i) ++counts[index.at(roulette(kFitness, 2, random))];
  EXPECT_LT(chi_square(counts, probabilities), chi_square_limit(counts.size() - 1));
}

TEST(Roulette, NeverDrawsTheSameTwice) {
  Random random(17);
  for (int i = 0; i < 1000; ++i) {
    std::vector<int> drawn = roulette(kFitness, 4, random);
    std::sort(drawn.begin(), drawn.end());
    ASSERT_EQ(drawn, (std::vector<int>{0, 1, 2, 3}));
  }
  EXPECT_TRUE(roulette({}, 0, random).empty());
}

TEST(Roulette, DrawsTheLeastFitnessOnlyWhenNothingElseIsLeft) {
  const std::vector<double> fitnesses = {kLeastFitness, 1.0, kLeastFitness, 1e-3};
  Random random(18);
  int first_of_least = 0;
  constexpr int n = 10000;
  for (int i = 0; i < n; ++i) {
    const std::vector<int> drawn = roulette(fitnesses, 3, random);
    ASSERT_EQ(drawn[0] + drawn[1], 1 + 3);
    first_of_least += drawn[2] == 0 ? 1 : 0;
  }
  // the two of them are equally likely
  EXPECT_NEAR(first_of_least, 0.5 * n, binomial_tolerance(n, 0.5));
}

TEST(GeneticOperators, RefuseWhatTheyCannotDo) {
  Random random(20);
  EXPECT_THROW((void)crossover({1}, {1, 2}, 1, 4), PreconditionError);
  EXPECT_THROW((void)crossover({1}, {2}, 5, 4), PreconditionError);
  EXPECT_THROW((void)crossover({1}, {2}, -1, 4), PreconditionError);
  EXPECT_THROW((void)with_bit_flipped({1}, 4, 4), PreconditionError);
  EXPECT_THROW((void)with_bit_flipped({1}, -1, 4), PreconditionError);
  EXPECT_THROW((void)children_of(individuals({{1}}), 1.0, 4, random), PreconditionError);
  EXPECT_THROW((void)roulette(kFitness, 5, random), PreconditionError);
}

// Number of generations after the initial population until the test is met.
int generations_until_converged(ConvergenceTest test,
                                const std::vector<std::vector<Genome>>& populations) {
  for (std::size_t i = 0; i < populations.size(); ++i) {
    if (test.converged(individuals(populations[i]))) return static_cast<int>(i);
  }
  return -1;
}

TEST(ConvergenceTest, IsMetAfterTheNumberOfGenerationsWithoutChange) {
  const std::vector<std::vector<Genome>> same(6, {{1}, {2}});
  EXPECT_EQ(generations_until_converged(ConvergenceTest(3), same), 3);
  EXPECT_EQ(generations_until_converged(ConvergenceTest(1), same), 1);
}

TEST(ConvergenceTest, DisregardsOrderAndCopies) {
  EXPECT_EQ(
      generations_until_converged(
          ConvergenceTest(3), {{{1}, {1}, {2}}, {{2}, {1}, {1}}, {{2}, {2}, {1}}, {{1}, {2}, {1}}}),
      3);
}

TEST(ConvergenceTest, StartsAgainWhenAGenomeComesOrGoes) {
  EXPECT_EQ(
      generations_until_converged(
          ConvergenceTest(2),
          {{{1}, {2}}, {{1}, {2}}, {{1}, {3}}, {{1}, {3}}, {{1}, {1}}, {{1}, {1}}, {{1}, {1}}}),
      6);
}

TEST(ConvergenceTest, EmptySetsAreTheSameToo) {
  EXPECT_EQ(generations_until_converged(ConvergenceTest(1), {{}, {}}), 1);
}

}  // namespace
}  // namespace shigusa
