// SPDX-License-Identifier: MIT
// One motion of 60 frames, and whole searches, by SIMD set and number of threads.
#include <benchmark/benchmark.h>

#include <shigusa/run.hpp>

#include "bench_problem.hpp"
#include "count_motions.hpp"
#include "plan/held_input.hpp"
#include "rollout/batch_rollout.hpp"
#include "rollout/rollout.hpp"
#include "search/genetic.hpp"

namespace shigusa::bench {
namespace {

constexpr int kScalarMotions = 32;
constexpr int kSearchMotions = 300;

// Delivery of motions: in double precision, one at a time.
void rollout_double(benchmark::State& state, const char* character) {
  const Measured measured(character, kScalarMotions);
  const CriteriaSettings criteria;
  Rollout<double> rollout(measured.problem);
  BuiltInCriteria<double> built_in(measured.task.body, measured.problem.context, criteria);
  std::vector<std::vector<double>> weights;
  for (const Parameters& p : measured.parameters) {
    weights.push_back(inverse_weights(measured.task.body, p));
  }
  const MotionCounter counter(state);
  for (auto _ : state) {
    for (const std::vector<double>& inverse : weights) {
      built_in.reset();
      benchmark::DoNotOptimize(
          rollout.run(inverse, [&](const PlacedFrame<double>& f) { built_in.add(f); }));
      benchmark::DoNotOptimize(built_in.score());
    }
  }
  counter.count(kScalarMotions);
}

void rollout_lanes(benchmark::State& state, const char* character, SimdSet simd, int threads) {
  const Measured measured(character, kMotions);
  const CriteriaSettings criteria;
  BatchRollout batch(measured.problem, criteria, {simd, threads});
  std::vector<double> scores(kMotions);
  // the first call allocates each thread's workspace
  batch.score(measured.inverse_weights, scores);
  const MotionCounter counter(state);
  for (auto _ : state) {
    batch.score(measured.inverse_weights, scores);
    benchmark::DoNotOptimize(scores.data());
  }
  counter.count(kMotions);
}

// Search alone, as generate() runs it, without setup of the problem and without delivery.
void search(benchmark::State& state, const char* character, SimdSet simd) {
  const Measured measured(character, 1);
  const CriteriaSettings criteria;
  SearchProblem searched;
  searched.genes = measured.task.body.dof_count();
  const auto lanes = static_cast<std::size_t>(simd_lanes(simd));
  double evaluations = 0.0;
  double places = 0.0;  // lanes of all batches
  std::uint64_t seed = 0;
  for (auto _ : state) {
    BatchRollout batch(measured.problem, criteria, {simd, 1});
    searched.evaluate = [&](std::span<const double> points, std::span<double> scores) {
      batch.score(inverse_weights_of_genes(genome_of_point(points, kPaperBitsPerGene)), scores);
      evaluations += static_cast<double>(scores.size());
      places += static_cast<double>((scores.size() + lanes - 1) / lanes * lanes);
    };
    GeneticSettings settings;
    settings.seed = ++seed;
    const SearchResult found = restarted_genetic_search(searched, settings, kSearchMotions);
    benchmark::DoNotOptimize(found.best_seen.score);
  }
  state.counters["evaluations"] =
      benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
  state.counters["lanes_filled"] = evaluations / places;
}

void register_set(SimdSet simd) {
  using benchmark::RegisterBenchmark;
  const std::string set = "/" + std::string(simd_name(simd));
  for (const char* character : {"half_body", "full_body"}) {
    const std::string name = "rollout/" + (character + set);
    RegisterBenchmark(name.c_str(), rollout_lanes, character, simd, 1);
  }
  RegisterBenchmark(("search/paper_half" + set).c_str(), search, "half_body", simd)
      ->Unit(benchmark::kMillisecond);
  RegisterBenchmark(("search/paper_full" + set).c_str(), search, "full_body", simd)
      ->Unit(benchmark::kMillisecond);
}

// One thread, two, four, … up to the number of cores; "real_time" follows the name.
void register_scaling() {
  const int cores = thread_count(0);
  for (int threads = 1; threads <= cores; threads *= 2) {
    const std::string name = "scaling/threads/" + std::to_string(threads);
    benchmark::RegisterBenchmark(name.c_str(), rollout_lanes, "full_body", widest_simd_set(),
                                 threads)
        ->UseRealTime();
  }
}

const bool kRegistered = [] {
  for (const char* character : {"half_body", "full_body"}) {
    const std::string name = "rollout/" + std::string(character) + "/double";
    benchmark::RegisterBenchmark(name.c_str(), rollout_double, character);
  }
  for (const SimdSet simd : usable_simd_sets()) register_set(simd);
  register_scaling();
  return true;
}();

}  // namespace
}  // namespace shigusa::bench
