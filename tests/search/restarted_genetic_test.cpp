// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/check.hpp"
#include "search/genetic.hpp"
#include "search/genome_problem.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

double sum_of_codes(const Genome& genome) {
  double sum = 0.0;
  for (const std::uint16_t code : genome) sum += code / 90.0;
  return sum;
}

// The sum of six codes; counts its evaluations.
SearchProblem sum_of_genes(int& scored) {
  return problem_of(6, 4, [&scored](const Genome& genome) {
    ++scored;
    return sum_of_codes(genome);
  });
}

TEST(MaxEvaluations, AreNeverExceeded) {
  for (int limit = kPaperPopulation; limit < 60; ++limit) {
    int scored = 0;
    GeneticSettings settings;
    settings.max_evaluations = limit;
    const SearchResult result = genetic_search(sum_of_genes(scored), settings);
    EXPECT_LE(scored, limit);
    EXPECT_EQ(scored, result.evaluations);
  }
}

TEST(MaxEvaluations, BelowThePopulationAreRefused) {
  int scored = 0;
  GeneticSettings settings;
  settings.max_evaluations = kPaperPopulation - 1;
  EXPECT_THROW((void)genetic_search(sum_of_genes(scored), settings), PreconditionError);
}

TEST(MaxEvaluations, ThatAreEnoughChangeNothing) {
  int scored = 0;
  GeneticSettings settings;
  const SearchResult free = genetic_search(sum_of_genes(scored), settings);
  settings.max_evaluations = 100'000;
  const SearchResult limited = genetic_search(sum_of_genes(scored), settings);
  EXPECT_EQ(free.final_population, limited.final_population);
}

TEST(RestartedGeneticSearch, EndsWhenNoGenomeIsLeft) {
  for (const int genes : {1, 2}) {
    GenomeRecorder recorder;
    const SearchProblem problem = recorder.watch(problem_of(genes, 4, sum_of_codes));
    const SearchResult result = restarted_genetic_search(problem, {}, 100'000);
    EXPECT_EQ(result.end, SearchEnd::converged);
    EXPECT_EQ(result.best_seen.score, 0.0);
    EXPECT_LE(result.evaluations, genes == 1 ? 16 : 256);
  }
}

TEST(RestartedGeneticSearch, BeginsWithTheSingleRunOfTheSeed) {
  int scored = 0;
  const SearchResult once = genetic_search(sum_of_genes(scored), {});
  const SearchResult often = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  EXPECT_TRUE(std::equal(once.final_population.begin(), once.final_population.end(),
                         often.final_population.begin()));
}

TEST(RestartedGeneticSearch, GathersTheFinalPopulationsOfAllRuns) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  EXPECT_GT(result.final_population.size(), 5U * kPaperPopulation);
}

TEST(RestartedGeneticSearch, RunsDiffer) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  std::set<Genome> genomes;
  for (const Individual& individual : result.final_population) {
    genomes.insert(genome_of(individual));
  }
  EXPECT_GT(genomes.size(), result.final_population.size() / 2);
}

TEST(RunsSideBySide, ScoreAGenomeThatTwoComeUponOnce) {
  // 256 genomes: runs of eight meet often
  GenomeRecorder recorder;
  const SearchResult result =
      restarted_genetic_search(recorder.watch(problem_of(2, 4, sum_of_codes)), {}, 200);
  const std::vector<Genome> all = recorder.all();
  EXPECT_EQ(std::set<Genome>(all.begin(), all.end()).size(), all.size());
  EXPECT_EQ(result.evaluations, static_cast<int>(all.size()));
  // the runs' populations do share genomes
  std::set<Genome> last;
  for (const Individual& individual : result.final_population) last.insert(genome_of(individual));
  EXPECT_LT(last.size(), result.final_population.size());
}

TEST(RunsSideBySide, ScoreFullBatchesOnly) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    GenomeRecorder recorder;
    (void)restarted_genetic_search(recorder.watch(problem_of(20, 4, sum_of_codes)), {.seed = seed},
                                   3001);
    std::vector<std::size_t> sizes;
    for (const auto& batch : recorder.batches) {
      if (!batch.empty()) sizes.push_back(batch.size());
    }
    // but for the last, where the budget ends
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i) EXPECT_EQ(sizes[i] % kFullBatch, 0U) << i;
  }
}

TEST(RunsSideBySide, BecomeMoreSoThatThreadsHaveMoreAtOnce) {
  // without offspring each run wants its initial population only
  GenomeRecorder recorder;
  (void)restarted_genetic_search(recorder.watch(problem_of(20, 4, sum_of_codes)),
                                 {.crossover_rate = 0.0, .mutation_rate = 0.0},
                                 120 * kPaperPopulation);
  std::size_t largest = 0;
  for (const auto& batch : recorder.batches) largest = std::max(largest, batch.size());
  ASSERT_FALSE(recorder.batches.empty());
  EXPECT_EQ(recorder.batches.front().size(), kRunsAtFirst * kPaperPopulation);
  EXPECT_GE(largest, 2 * kRunsAtFirst * kPaperPopulation);
}

}  // namespace
}  // namespace shigusa
