// SPDX-License-Identifier: MIT
// One motion of 60 frames, and whole searches, by SIMD set; what threads bring.
#include <benchmark/benchmark.h>

#include <shigusa/hierarchy/generator.hpp>
#include <shigusa/rollout/batch_rollout.hpp>
#include <shigusa/rollout/rollout.hpp>

#include "bench_problem.hpp"

namespace shigusa::bench {
namespace {

constexpr int kMotions = 480;  // full lanes in every set
constexpr int kSearchMotions = 300;

void count_motions(benchmark::State& state, double motions) {
  state.counters["motions/s"] = benchmark::Counter(
      motions * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["us/motion"] =
      benchmark::Counter(motions * static_cast<double>(state.iterations()) * 1e-6,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// What delivers motions: double precision, one at a time.
void rollout_double(benchmark::State& state, const char* character) {
  const Measured measured(character, 32);
  const CriteriaSettings criteria;
  Rollout<double> rollout(measured.problem);
  BuiltInCriteria<double> built_in(measured.task.body, criteria);
  std::vector<std::vector<double>> weights;
  for (const Parameters& p : measured.parameters) weights.push_back(inverse_weights(p));
  for (auto _ : state) {
    for (const std::vector<double>& inverse : weights) {
      built_in.reset();
      benchmark::DoNotOptimize(rollout.run(
          inverse,
          [&](const MotionFrame<double>& f, const Kinematics<double>&) { built_in.add(f); }));
      benchmark::DoNotOptimize(built_in.score());
    }
  }
  count_motions(state, static_cast<double>(weights.size()));
}

void rollout_lanes(benchmark::State& state, const char* character, SimdSet simd, int threads) {
  const Measured measured(character, kMotions);
  const CriteriaSettings criteria;
  BatchRollout batch(measured.problem, criteria, {simd, threads});
  std::vector<double> scores(kMotions);
  for (auto _ : state) {
    batch.score(measured.inverse_weights, scores);
    benchmark::DoNotOptimize(scores.data());
  }
  count_motions(state, kMotions);
}

// The search alone, as generate() runs it: the problem is at hand, nothing is delivered.
void search(benchmark::State& state, const char* character, SimdSet simd) {
  const Measured measured(character, 1);
  const CriteriaSettings criteria;
  const auto dofs = static_cast<std::size_t>(measured.task.body.dof_count());
  int evaluations = 0;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    BatchRollout batch(measured.problem, criteria, {simd, 1});
    DiscreteProblem discrete;
    discrete.genes = static_cast<int>(dofs);
    discrete.evaluate = [&](std::span<const std::uint16_t> genomes, std::span<double> scores) {
      batch.score(inverse_weights_of(genomes), scores);
    };
    GeneticSettings settings;
    settings.seed = ++seed;
    const SearchResult found = restarted_genetic_search(discrete, settings, kSearchMotions);
    evaluations += found.evaluations;
    benchmark::DoNotOptimize(found.best_seen.score);
  }
  state.counters["evaluations"] =
      benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
}

const bool kRegistered = [] {
  using benchmark::RegisterBenchmark;
  const auto name = [](const char* what, const char* character, std::string_view set) {
    return std::string(what) + character + "/" + std::string(set);
  };
  for (const char* character : {"half_body", "full_body"}) {
    RegisterBenchmark(name("rollout/", character, "double").c_str(), rollout_double, character);
    for (const SimdSet simd : usable_simd_sets()) {
      RegisterBenchmark(name("rollout/", character, simd_name(simd)).c_str(), rollout_lanes,
                        character, simd, 1);
    }
  }
  for (const SimdSet simd : usable_simd_sets()) {
    for (const auto& [label, character] :
         {std::pair{"half", "half_body"}, std::pair{"full", "full_body"}}) {
      RegisterBenchmark(name("search/paper_", label, simd_name(simd)).c_str(), search, character,
                        simd)
          ->Unit(benchmark::kMillisecond);
    }
  }
  for (const int threads : {1, 2, 4, 8}) {
    RegisterBenchmark(("scaling/threads/" + std::to_string(threads)).c_str(), rollout_lanes,
                      "full_body", widest_simd_set(), threads)
        ->UseRealTime();
  }
  return true;
}();

}  // namespace
}  // namespace shigusa::bench
