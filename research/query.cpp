// SPDX-License-Identifier: MIT
// shigusa_query SIMD_SET ROUNDS runs one default query ROUNDS times on one thread, and prints the
// median CPU time (ms) and the peak resident memory (KiB) of the process. It is a separate program,
// run by shigusa_experiments, which has other libraries loaded.
#include <algorithm>
#include <ctime>
#include <fstream>
#include <iostream>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <string>
#include <vector>

namespace {

using namespace shigusa;

// Not from getrusage, whose value starts with that of the parent process.
long peak_kibibytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long value = 0;
    if (word == "VmHWM:" && status >> value) return value;
  }
  return 0;
}

Task default_task() {
  Task task(full_body());
  task.goals = {{"right_hand", {0.25, 0.55, 0.50}}};
  task.batch.threads = 1;
  return task;
}

}  // namespace

int main(int argc, char** argv) {
  const auto simd = argc == 3 ? find_simd(argv[1]) : std::nullopt;
  const int rounds = argc == 3 ? std::stoi(argv[2]) : 0;
  if (!simd || rounds < 1) {
    std::cerr << "usage: shigusa_query SIMD_SET ROUNDS\n";
    return 2;
  }
  Task task = default_task();
  task.batch.simd = *simd;
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t begin = std::clock();
    const GenerateResult generation = generate(task).value();
    times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    // the full budget is timed, and the goal must be met
    if (generation.log.evaluations < kFlatEvaluations - kFlatEvaluations / 100) return 1;
    if (!generation.meets_goals()) return 1;
  }
  std::sort(times.begin(), times.end());
  std::cout << times[times.size() / 2] << " " << peak_kibibytes() << "\n";
  return 0;
}
