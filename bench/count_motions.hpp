// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <ctime>

namespace shigusa::bench {

// Counters motions/s and us/motion, by CPU time of the process. Construct one before the measured
// loop and call `count` after it.
class MotionCounter {
 public:
  explicit MotionCounter(benchmark::State& state) : state_(state), begin_(std::clock()) {}

  void count(double motions_per_iteration) const {
    const double seconds = static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC;
    const double motions = motions_per_iteration * static_cast<double>(state_.iterations());
    state_.counters["motions/s"] = benchmark::Counter(motions, benchmark::Counter::kIsRate);
    state_.counters["us/motion"] = 1e6 * seconds / motions;
  }

 private:
  benchmark::State& state_;
  std::clock_t begin_;
};

}  // namespace shigusa::bench
