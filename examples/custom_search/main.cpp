// SPDX-License-Identifier: MIT
// A search of one's own: any function that takes a problem over the unit cube and scores points in
// batches. This one is a (1+λ) evolution strategy; it is run on the joint weights of a reach beside
// the library's own searches.
#include <algorithm>
#include <cstdio>
#include <shigusa/core/random.hpp>
#include <shigusa/rollout/detour.hpp>
#include <shigusa/search/searches.hpp>
#include <shigusa/shigusa.hpp>
#include <string>

namespace {

using shigusa::Individual;
using shigusa::SearchProblem;
using shigusa::SearchResult;

// From the best so far, λ mutants at a time; the step grows when one of them is better and shrinks
// when none is (Rechenberg's rule of success). The budget decides where it stops and nothing else.
SearchResult one_plus_lambda(const SearchProblem& problem, int evaluations, std::uint64_t seed) {
  const std::size_t genes = static_cast<std::size_t>(problem.genes);
  constexpr std::size_t lambda = 16;  // full vector registers
  shigusa::Random random(seed);
  SearchResult result;
  result.best_seen = {std::vector<double>(genes, 0.5), 1e9};
  for (double step = 0.3; result.evaluations < evaluations; ++result.generations) {
    const std::size_t left = static_cast<std::size_t>(evaluations - result.evaluations);
    std::vector<double> points;
    std::vector<double> scores(std::min(lambda, left));
    for (std::size_t i = 0; i < lambda * genes; ++i) {
      const double mutated = result.best_seen.point[i % genes] + random.uniform(-step, step);
      points.push_back(std::clamp(mutated, 0.0, 1.0));
    }
    problem.evaluate(std::span(points).first(scores.size() * genes), scores);
    result.evaluations += static_cast<int>(scores.size());
    const auto best = std::min_element(scores.begin(), scores.end());
    const bool better = *best < result.best_seen.score;
    if (better) {
      const auto point = points.begin() + (best - scores.begin()) * problem.genes;
      result.best_seen = Individual{{point, point + problem.genes}, *best};
    }
    step = std::clamp(step * (better ? 1.3 : 0.85), 1e-3, 0.5);
  }
  result.final_population = {result.best_seen};
  return result;
}

// A joint's weight at its coordinate: 0.004 to 245, even in the logarithm.
double weight_at(double x) { return shigusa::exponential(11.0 * x - 5.5); }

}  // namespace

int main() {
  shigusa::Task task{.body = shigusa::full_body()};
  task.goals = {{"right_hand", {-0.20, 0.60, 0.55}}};
  auto reach = shigusa::make_problem(task);
  if (!reach) {
    std::fprintf(stderr, "%s\n", reach.error().to_string().c_str());
    return 1;
  }
  shigusa::add_detours(*reach);
  shigusa::BatchRollout batch(*reach, task.criteria);
  SearchProblem problem;
  problem.genes = task.body.dof_count();
  problem.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    std::vector<float> inverse_weights;
    for (const double x : points) inverse_weights.push_back(static_cast<float>(1 / weight_at(x)));
    batch.score(inverse_weights, scores);
  };

  constexpr int evaluations = 1000;
  const SearchResult ours = one_plus_lambda(problem, evaluations, 1);
  std::printf("%-12s best score %.4f\n", "ours", ours.best_seen.score);
  for (const shigusa::SearchMethod method : shigusa::kSearchMethods) {
    // its codes would be the paper's weights, which this problem does not have
    if (method == shigusa::SearchMethod::paper_ga) continue;
    const SearchResult found = shigusa::search(method, problem, evaluations, 1);
    std::printf("%-12s best score %.4f\n", std::string(shigusa::search_name(method)).c_str(),
                found.best_seen.score);
  }

  shigusa::Parameters parameters = shigusa::uniform_parameters(task.body);
  for (std::size_t d = 0; d < parameters.joints.size(); ++d) {
    parameters.joints[d].weight = weight_at(ours.best_seen.point[d]);
  }
  const auto motion = shigusa::regenerate(task, parameters);
  if (!motion) return 1;
  std::printf("our motion, played in double: score %.4f, %.2f mm off its goal\n",
              motion->candidates[0].score.total, 1e3 * motion->candidates[0].goals[0].error);
  return motion->status == shigusa::ReachStatus::reached ? 0 : 1;
}
