// SPDX-License-Identifier: MIT
// Scoring time of a motion of the whole human in two plans: by layers, and with all parameters at
// once.
#include <benchmark/benchmark.h>

#include <shigusa/run.hpp>

#include "bench_problem.hpp"
#include "count_motions.hpp"
#include "generate/layered_approaches.hpp"
#include "generate/layered_search.hpp"
#include "generate/parameter_space.hpp"
#include "problem/plan_of.hpp"
#include "rollout/batch_rollout.hpp"

namespace shigusa::bench {
namespace {

Task human_task(Preset preset) {
  return with_preset(Task(human_body(), {.goals = {{"right_hand", kLowFrontLeft}}}), preset);
}

// (motions × genes) around the middle, where searches spend most of their time
std::vector<double> random_points(std::size_t genes) {
  Random random(7);
  std::vector<double> points;
  for (std::size_t k = 0; k < kMotions * genes; ++k) points.push_back(random.uniform(0.3, 0.7));
  return points;
}

void score_flat(benchmark::State& state, SimdSet simd) {
  const Task task = human_task(Preset::flat);
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = parameter_list(plan_of(task.body, task.start, task).value());
  ParameterSpace space(problem, list, GeneCode::natural);
  const std::vector<double> points = random_points(static_cast<std::size_t>(space.genes()));
  BatchRollout batch(problem, task.criteria, {simd, 1});
  std::vector<double> scores(kMotions);
  const MotionCounter counter(state);
  for (auto _ : state) {
    batch.score(space.rows(points), scores);
    benchmark::DoNotOptimize(scores.data());
  }
  counter.count(kMotions);
}

void score_layers(benchmark::State& state, SimdSet simd) {
  const Task task = human_task(Preset::human);
  const LayeredProblem problem =
      in_layers(make_problem(task).value(), plan_of(task.body, task.start, task).value());
  const std::vector<std::size_t> genes = searched_genes(problem);
  const std::vector<double> points = random_points(genes.size());
  std::vector<LayeredValues> parameters;
  for (std::size_t i = 0; i < kMotions; ++i) {
    const auto point = std::span<const double>(points).subspan(i * genes.size(), genes.size());
    parameters.push_back(decode_searched(problem, genes, point, false));
  }
  LayeredScorer scorer(problem, problem.layers[0].criteria, {simd, 1}, {});
  std::vector<double> scores(kMotions);
  const MotionCounter counter(state);
  for (auto _ : state) {
    scorer.score(parameters, scores);
    benchmark::DoNotOptimize(scores.data());
  }
  counter.count(kMotions);
}

const bool kRegistered = [] {
  for (const SimdSet simd : usable_simd_sets()) {
    const std::string set(simd_name(simd));
    benchmark::RegisterBenchmark(("plan/flat/" + set).c_str(), score_flat, simd);
    benchmark::RegisterBenchmark(("plan/human/" + set).c_str(), score_layers, simd);
  }
  return true;
}();

}  // namespace
}  // namespace shigusa::bench
