// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <shigusa/core/check.hpp>
#include <shigusa/search/genetic.hpp>
#include <vector>

namespace shigusa {
namespace {

// The sum of six genes; counts what it scores.
DiscreteProblem sum_of_genes(int& scored) {
  DiscreteProblem problem;
  problem.genes = 6;
  problem.evaluate = [&scored](std::span<const std::uint16_t> genomes, std::span<double> scores) {
    scored += static_cast<int>(scores.size());
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i] = 0.0;
      for (std::size_t g = 0; g < 6; ++g) scores[i] += genomes[i * 6 + g] / 90.0;
    }
  };
  return problem;
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

TEST(RestartedGeneticSearch, UsesItsBudgetUpToLessThanAPopulation) {
  for (const int budget : {8, 100, 1000, 1007}) {
    int scored = 0;
    const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, budget);
    EXPECT_LE(scored, budget);
    EXPECT_GT(scored, budget - kPaperPopulation);
    EXPECT_EQ(scored, result.evaluations);
    EXPECT_EQ(result.end, SearchEnd::budget);
  }
}

TEST(RestartedGeneticSearch, BeginsWithTheSingleRunOfTheSeed) {
  int scored = 0;
  const SearchResult once = genetic_search(sum_of_genes(scored), {});
  const SearchResult often = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  const auto begin = often.final_population.begin();
  EXPECT_TRUE(std::equal(once.final_population.begin(), once.final_population.end(), begin));
}

TEST(RestartedGeneticSearch, GathersTheFinalPopulationsOfAllRuns) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  EXPECT_GT(result.final_population.size(), 5U * kPaperPopulation);
  EXPECT_EQ(result.final_population.size() % kPaperPopulation, 0U);
}

TEST(RestartedGeneticSearch, RunsDiffer) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  std::set<std::vector<std::uint16_t>> genomes;
  for (const Individual& individual : result.final_population) genomes.insert(individual.genes);
  EXPECT_GT(genomes.size(), result.final_population.size() / 2);
}

TEST(RestartedGeneticSearch, BestSeenIsTheBestOfAllRuns) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  for (const Individual& individual : result.final_population) {
    EXPECT_LE(result.best_seen.score, individual.score);
  }
}

TEST(RestartedGeneticSearch, ReportsGrowingShareOfTheBudget) {
  int scored = 0;
  Progress progress;
  double fraction = 0.0;
  double best = 1e9;
  progress.report = [&](const ProgressReport& report) {
    EXPECT_GE(report.fraction, fraction);
    EXPECT_LE(report.fraction, 1.0);
    EXPECT_LE(report.best_score, best);
    fraction = report.fraction;
    best = report.best_score;
  };
  (void)restarted_genetic_search(sum_of_genes(scored), {}, 1000, progress);
  EXPECT_GT(fraction, 0.9);
}

TEST(RestartedGeneticSearch, CancelledEndsWithTheBestSoFar) {
  int scored = 0;
  std::atomic<bool> cancel{false};
  Progress progress;
  progress.cancel = &cancel;
  progress.report = [&](const ProgressReport& report) { cancel = report.evaluations > 200; };
  const SearchResult result =
      restarted_genetic_search(sum_of_genes(scored), {}, 1'000'000, progress);
  EXPECT_EQ(result.end, SearchEnd::cancelled);
  EXPECT_LT(result.evaluations, 300);
  EXPECT_FALSE(result.best_seen.genes.empty());
}

// Keeps the size of each batch and every genome scored.
struct Record {
  std::vector<std::size_t> batches;
  std::vector<Genome> genomes;

  // `genes` of `bits` bits each
  DiscreteProblem problem(int genes, int bits) {
    DiscreteProblem result;
    result.genes = genes;
    result.bits_per_gene = bits;
    result.evaluate = [this, genes](std::span<const std::uint16_t> packed,
                                    std::span<double> scores) {
      batches.push_back(scores.size());
      const auto length = static_cast<std::size_t>(genes);
      for (std::size_t i = 0; i < scores.size(); ++i) {
        const auto genome = packed.subspan(i * length, length);
        genomes.emplace_back(genome.begin(), genome.end());
        scores[i] = 0.0;
        for (const std::uint16_t gene : genome) scores[i] += gene / 90.0;
      }
    };
    return result;
  }
};

TEST(RunsSideBySide, ScoreAGenomeThatTwoComeUponOnce) {
  // 256 genomes: sixteen runs of eight meet often
  Record record;
  const SearchResult result = restarted_genetic_search(record.problem(2, 4), {}, 200);
  const std::set<Genome> distinct(record.genomes.begin(), record.genomes.end());
  EXPECT_EQ(distinct.size(), record.genomes.size());
  EXPECT_EQ(result.evaluations, static_cast<int>(record.genomes.size()));
  // the runs' populations do share genomes
  std::set<Genome> last;
  for (const Individual& individual : result.final_population) last.insert(individual.genes);
  EXPECT_LT(last.size(), result.final_population.size());
}

TEST(RunsSideBySide, BeginWithAllTheirPopulationsInOneBatch) {
  for (const int runs : {1, 3, kRunsAtOnce}) {
    Record record;
    (void)restarted_genetic_search(record.problem(20, 4), {}, runs * kEvaluationsPerRun);
    EXPECT_EQ(record.batches[0], static_cast<std::size_t>(runs * kPaperPopulation));
  }
}

TEST(RunsSideBySide, AreNoMoreThanTheirLimit) {
  Record record;
  (void)restarted_genetic_search(record.problem(20, 4), {}, 100 * kEvaluationsPerRun);
  EXPECT_EQ(record.batches[0], static_cast<std::size_t>(kRunsAtOnce * kPaperPopulation));
}

TEST(RunsSideBySide, FillSixteenLanesInMostBatches) {
  // the paper's 300 motions: four runs
  std::size_t lanes = 0;
  std::size_t motions = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Record record;
    (void)restarted_genetic_search(record.problem(20, 4), {.seed = seed}, 300);
    for (const std::size_t size : record.batches) {
      motions += size;
      lanes += (size + 15) / 16 * 16;
    }
  }
  EXPECT_GT(static_cast<double>(motions) / static_cast<double>(lanes), 0.6);
  RecordProperty("lanes_filled_percent", static_cast<int>(100 * motions / lanes));
}

TEST(RunsSideBySide, DoNotDependOnHowABatchIsScored) {
  const auto search = [](bool one_by_one) {
    Record record;
    DiscreteProblem whole = record.problem(20, 4);
    DiscreteProblem parted = whole;
    parted.evaluate = [&](std::span<const std::uint16_t> packed, std::span<double> scores) {
      // from the last genome to the first
      for (std::size_t i = scores.size(); i-- > 0;) {
        whole.evaluate(packed.subspan(i * 20, 20), scores.subspan(i, 1));
      }
    };
    return restarted_genetic_search(one_by_one ? parted : whole, {.seed = 5}, 1000);
  };
  const SearchResult together = search(false);
  const SearchResult alone = search(true);
  EXPECT_EQ(together.final_population, alone.final_population);
  EXPECT_EQ(together.best_seen, alone.best_seen);
  EXPECT_EQ(together.evaluations, alone.evaluations);
  EXPECT_EQ(together.generations, alone.generations);
}

}  // namespace
}  // namespace shigusa
