// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/search.hpp>

#include "search/genetic_operators.hpp"

namespace shigusa {

// The paper's genetic algorithm (section 3.2, with rule R7 for its open points); its steps are the
// functions of genetic_operators.hpp. It searches over strings of codes, with bits_per_gene bits
// for each coordinate; a code stands for the midpoint of its share of [0, 1] (point_of_genome). The
// problem defines the meaning of a share: the paper's own search (16 shares for the weights 0..15)
// and the one over logarithmic weights are the same algorithm on two problems.
//
//   population := `population` random genomes
//   repeat until the population, as a set, is unchanged for `unchanged_generations` generations,
//          or `max_generations` have passed, or `max_evaluations` are used up:
//     shuffle into pairs; each pair, with crossover_rate, gives two children by one-point
//       crossover of the concatenated bit string; parents stay
//     each parent, with mutation_rate, gives a copy with one random bit flipped
//     pool := parents + children + mutants
//     next population := `population` draws from the pool by roulette on fitness
//       1 / (fitness_offset + score), without replacement
//
// No elitism, as the paper's selection is random: the best of all evaluated genomes is kept
// separately in best_seen. "As a set" disregards the order and the number of copies of a genome.
//
// Scoring: each generation's genomes that are new to this search go to problem.evaluate in one call
// (children, then mutants, equal ones once), so a genome is never scored twice. If a batch exceeds
// `max_evaluations`, its first genomes are scored, and the generation is not completed. The
// problem's start is not used: the paper's initial population is random. Scores should be ≥ 0; the
// roulette counts a negative one as 0. A NaN score is rejected: it counts as +infinity and has the
// least fitness. The memory grows by one genome per scoring.
//
// `progress` is reported after the initial population and after each generation, on the caller's
// thread. Cancelling lets the current generation finish, and has no effect if it is the last; the
// initial population is always scored, so best_seen is one of the scored genomes even after an
// early cancellation.
//
// The result depends on problem and settings only: same seed, same result. Settings or a problem
// outside the stated ranges throw PreconditionError; exceptions of problem.evaluate pass through.
[[nodiscard]] SearchResult genetic_search(const SearchProblem& problem,
                                          const GeneticSettings& settings,
                                          const Progress& progress = {});

// Largest number of simultaneous runs in restarted_genetic_search, so that a batch fills many
// lanes.
inline constexpr int kRunsAtOnce = 16;
// Number of simultaneous runs until the first have ended.
inline constexpr std::size_t kRunsAtFirst = 4;
// Size of a full batch of genomes: the lanes of the widest set, on every machine.
inline constexpr std::size_t kFullBatch = 16;
// Number of successive runs without a new genome after which the search has converged.
inline constexpr int kRunsWithoutNew = 64;

// Repeats the genetic algorithm, with the streams 0, 1, 2, … of the seed, until `evaluations` (≥
// population) are used up: an equal budget for every search. First kRunsAtFirst runs in parallel,
// later the largest power of two not above the number of runs that have ended, at most kRunsAtOnce:
// 4, 4, 8, 16, 16, … Their genomes wait in one queue, the first of which are scored in full batches
// (if one would not be full, another run starts); a run continues as soon as all its genomes are
// scored. A genome common to several runs is scored once. The final population is that of all runs
// together, by stream; generations are summed.
[[nodiscard]] SearchResult restarted_genetic_search(const SearchProblem& problem,
                                                    const GeneticSettings& settings,
                                                    int evaluations, const Progress& progress = {});

}  // namespace shigusa
