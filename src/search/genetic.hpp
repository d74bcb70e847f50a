// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/search.hpp>

#include "search/genetic_operators.hpp"

namespace shigusa {

// The paper's genetic algorithm (section 3.2, with rule R7 for what it leaves open); its steps are
// the functions of genetic_operators.hpp. It searches over strings of codes, bits_per_gene bits for
// each coordinate; a code stands for the middle of its share of [0, 1] (point_of_genome). The
// problem decides what a share means: the paper's own search (16 shares are the weights 0..15) and
// the one over logarithmic weights are this same algorithm on two problems.
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
// No elitism, as the paper's selection is purely by chance: the best of all evaluated genomes is
// kept aside in best_seen. "As a set" disregards order and how many copies there are of a genome.
//
// Scoring: each generation's genomes that are new to this search go to problem.evaluate in one call
// (children, then mutants, equal ones once), so a genome is never scored twice. Of a batch that
// exceeds `max_evaluations` the first genomes are scored, and the generation is not completed. The
// problem's start is not used: the paper begins by chance. Scores are meant to be ≥ 0; the roulette
// takes a negative one for 0. A NaN score is rejected: it counts as +infinity and keeps only the
// least fitness there is. The memory grows by one genome per scoring.
//
// `progress` is told after the initial population and after each generation, on the caller's
// thread. Cancelling lets the generation under way finish, and has no effect if it is the last; the
// initial population is always scored, so best_seen is one of the scored genomes even if the work
// was cancelled before it began.
//
// The result depends on problem and settings only: same seed, same result. Settings or a problem
// outside the stated ranges throw PreconditionError; what problem.evaluate throws passes through.
[[nodiscard]] SearchResult genetic_search(const SearchProblem& problem,
                                          const GeneticSettings& settings,
                                          const Progress& progress = {});

// Most runs that restarted_genetic_search has going at once, so that a batch fills many lanes.
inline constexpr int kRunsAtOnce = 16;
// How many go on until the first have ended.
inline constexpr std::size_t kRunsAtFirst = 4;
// Genomes are scored in multiples of this number: the lanes of the widest set, on every machine.
inline constexpr std::size_t kFullBatch = 16;
// It ends as converged when this many runs in succession came upon no genome that was new.
inline constexpr int kRunsWithoutNew = 64;

// The genetic algorithm again and again, with the streams 0, 1, 2, … of the seed, until
// `evaluations` (≥ population) are used up: an equal budget for every search. First kRunsAtFirst
// side by side, later as many as the largest power of two that is not above the number of runs that
// have ended, kRunsAtOnce at most: 4, 4, 8, 16, 16, … Their genomes wait in one queue, the first of
// which are scored in full batches (where one would not be full, another run starts); a run goes on
// as soon as all of its own are scored. A genome that two of them come upon is scored once. The
// final population is that of all runs together, by stream; generations are summed.
[[nodiscard]] SearchResult restarted_genetic_search(const SearchProblem& problem,
                                                    const GeneticSettings& settings,
                                                    int evaluations, const Progress& progress = {});

}  // namespace shigusa
