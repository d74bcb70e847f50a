// SPDX-License-Identifier: MIT
// A search of one's own: any function that takes a problem over the unit cube and scores points in
// batches. This one is a (1+λ) evolution strategy; generate() runs it in the place of the
// library's.
#include <algorithm>
#include <cstdio>
#include <shigusa/run.hpp>
#include <shigusa/shigusa.hpp>
#include <string>

namespace {

using shigusa::Individual;
using shigusa::SearchProblem;
using shigusa::SearchResult;

// From the best so far, λ mutants at a time; the step grows when one of them is better and shrinks
// when none is (Rechenberg's rule of success). The budget decides where it stops and nothing else.
SearchResult one_plus_lambda(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                             const shigusa::Progress&) {
  const std::size_t genes = static_cast<std::size_t>(problem.genes);
  constexpr std::size_t lambda = 16;  // full vector registers
  shigusa::Random random(seed);
  SearchResult result;
  result.best_seen = {problem.start, 1e9};
  for (double step = 0.3; result.evaluations < evaluations; ++result.generations) {
    const std::size_t left = static_cast<std::size_t>(evaluations - result.evaluations);
    std::vector<double> points;
    std::vector<double> scores(std::min(lambda, left));
    for (std::size_t i = 0; i < scores.size() * genes; ++i) {
      const double mutated = result.best_seen.point[i % genes] + random.uniform(-step, step);
      points.push_back(std::clamp(mutated, 0.0, 1.0));
    }
    problem.evaluate(points, scores);
    result.evaluations += static_cast<int>(scores.size());
    const auto best = std::min_element(scores.begin(), scores.end());
    const bool better = *best < result.best_seen.score;
    if (better) {
      const auto point = points.begin() + (best - scores.begin()) * problem.genes;
      result.best_seen = Individual{{point, point + problem.genes}, *best};
    }
    step = std::clamp(step * (better ? 1.3 : 0.85), 1e-3, 0.5);
  }
  return result;
}

}  // namespace

int main() {
  shigusa::Task task(shigusa::full_body());
  task.goals = {{"right_hand", {-0.20, 0.60, 0.55}}};
  task.evaluations = 1000;
  for (const shigusa::SearchInfo& known : shigusa::kSearches) {
    task.search = known.method;
    const auto found = shigusa::generate(task);
    std::printf("%-10s best score %.4f\n", std::string(known.word).c_str(),
                found ? found->best_seen_score : 1.0);
  }
  task.own_search = one_plus_lambda;
  const auto ours = shigusa::generate(task);
  if (!ours) {
    std::fprintf(stderr, "%s\n", ours.error().to_string().c_str());
    return 1;
  }
  std::printf("%-10s best score %.4f\n", "ours", ours->best_seen_score);
  for (const shigusa::Candidate& candidate : ours->candidates) {
    std::printf("  candidate: score %.4f, %.2f mm off its goal, %s\n", candidate.score.total,
                1e3 * candidate.goals[0].error,
                shigusa::posture_words(candidate.final_posture).c_str());
  }
  return ours->status == shigusa::ReachStatus::reached ? 0 : 1;
}
