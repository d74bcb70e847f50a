// SPDX-License-Identifier: MIT
// Time of each stage of a rollout: one frame in all lanes, in the widest sets; the cost of
// forbidding fused multiply-add; and the peak arithmetic rate of a core.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <shigusa/run.hpp>
#include <string>
#include <utility>

#include "bench_problem.hpp"
#include "stages.hpp"

namespace shigusa::bench {
namespace {

using MakeStages = std::unique_ptr<Stages> (*)(const StagesInput&);

struct Input {
  Measured measured;
  CriteriaSettings criteria;
  std::unique_ptr<Stages> stages;

  Input(const char* character, MakeStages make) : measured(character, kMotions) {
    stages = make({&measured.problem, &criteria, measured.inverse_weights});
  }
};

void run_stage(benchmark::State& state, const char* character, MakeStages make, Stage stage) {
  const Input input(character, make);
  for (auto _ : state) input.stages->run(stage);
  state.counters["lanes"] = input.stages->lanes();
}

void run_peak(benchmark::State& state, MakeStages make) {
  const Input input("half_body", make);
  for (auto _ : state) input.stages->peak();
  const double operations =
      static_cast<double>(state.iterations()) * kPeakOperations * input.stages->lanes();
  state.counters["operations/s"] = benchmark::Counter(operations, benchmark::Counter::kIsRate);
}

constexpr std::pair<Stage, const char*> kStages[] = {
    {Stage::forward_kinematics, "forward_kinematics"},
    {Stage::ik_rows, "ik_rows"},
    {Stage::ik_products, "ik_products"},
    {Stage::ik_solve, "ik_solve"},
    {Stage::ik, "ik"},
    {Stage::dynamics, "dynamics"},
    {Stage::criteria, "criteria"},
    {Stage::motion, "motion"},
};

void register_set(const std::string& set, MakeStages make) {
  for (const char* character : {"half_body", "full_body"}) {
    for (const auto& [stage, label] : kStages) {
      const std::string name = "stage/" + std::string(character) + "/" + label + "/" + set;
      benchmark::RegisterBenchmark(name.c_str(), run_stage, character, make, stage);
    }
  }
  benchmark::RegisterBenchmark(("peak/" + set).c_str(), run_peak, make);
}

#ifdef SHIGUSA_HAS_AVX
bool usable(SimdSet set) {
  const auto sets = usable_simd_sets();
  return std::find(sets.begin(), sets.end(), set) != sets.end();
}

void register_fused(const std::string& set, MakeStages make) {
  if (!__builtin_cpu_supports("fma")) return;
  for (const char* character : {"half_body", "full_body"}) {
    const std::string name = "stage/" + std::string(character) + "/motion/" + set + "_fma";
    benchmark::RegisterBenchmark(name.c_str(), run_stage, character, make, Stage::motion);
  }
}
#endif

const bool kRegistered = [] {
  register_set(std::string(simd_name(SimdSet::lanes_4)), make_lanes_4_stages);
#ifdef SHIGUSA_HAS_AVX
  if (usable(SimdSet::avx2)) {
    register_set("avx2", make_avx2_stages);
    register_fused("avx2", make_avx2_fma_stages);
  }
  if (usable(SimdSet::avx512)) {
    register_set("avx512", make_avx512_stages);
    register_fused("avx512", make_avx512_fma_stages);
  }
#endif
  return true;
}();

}  // namespace
}  // namespace shigusa::bench
