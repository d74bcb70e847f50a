// SPDX-License-Identifier: MIT
// Mean number of floating-point operations of a motion: counted, not timed. Each motion is counted
// separately; in lanes it also waits for its neighbours' corrections.
#include <benchmark/benchmark.h>

#include "bench_problem.hpp"
#include "counted.hpp"
#include "rollout/batch_rollout.hpp"
#include "rollout/rollout.hpp"

namespace shigusa::bench {
namespace {

// Largest difference between the scores of counted motions and those of one lane.
double difference(const Measured& measured, const CriteriaSettings& criteria,
                  const std::vector<Counted>& scores) {
  std::vector<double> expected(scores.size());
  BatchRollout(measured.problem, criteria, {SimdSet::scalar, 1})
      .score(measured.inverse_weights, expected);
  double largest = 0.0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    largest = max(largest, abs(expected[i] - static_cast<double>(scores[i].value())));
  }
  return largest;
}

std::vector<Counted> count_motions(const Measured& measured, const CriteriaSettings& criteria) {
  Rollout<Counted> rollout(measured.problem);
  BuiltInCriteria<Counted> built_in(measured.task.body, measured.problem.context, criteria);
  const std::size_t dofs = measured.task.body.dofs().size();
  std::vector<Counted> scores;
  std::vector<Counted> inverse(dofs);
  Counted::done = {};
  for (std::size_t motion = 0; motion < measured.parameters.size(); ++motion) {
    for (std::size_t d = 0; d < dofs; ++d) {
      inverse[d] = Counted(measured.inverse_weights[motion * dofs + d]);
    }
    built_in.reset();
    const auto outcome =
        rollout.run(inverse, [&](const PlacedFrame<Counted>& f) { built_in.add(f); });
    const Counted score = built_in.score();
    scores.push_back(
        outcome.met(measured.problem.tolerance).value ? score : Counted(worst_score(criteria)));
  }
  return scores;
}

void count(benchmark::State& state, const char* character) {
  const Measured measured(character, kMotions);
  const CriteriaSettings criteria;
  std::vector<Counted> scores;
  for (auto _ : state) scores = count_motions(measured, criteria);
  if (difference(measured, criteria, scores) > 0.0) {
    state.SkipWithError("the counted motions are not those of the kernel");
    return;
  }
  const Operations& done = Counted::done;
  const auto per_motion = [&](std::int64_t n) { return static_cast<double>(n) / kMotions; };
  state.counters["additions"] = per_motion(done.additions);
  state.counters["multiplications"] = per_motion(done.multiplications);
  state.counters["divisions"] = per_motion(done.divisions);
  state.counters["square_roots"] = per_motion(done.square_roots);
  state.counters["comparisons"] = per_motion(done.comparisons);
  // number of times that the body is placed
  state.counters["placements"] = per_motion(done.sines) / measured.task.body.dof_count();
}

const bool kRegistered = [] {
  for (const char* character : {"half_body", "full_body"}) {
    const std::string name = "operations/" + std::string(character);
    benchmark::RegisterBenchmark(name.c_str(), count, character)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace shigusa::bench
