// SPDX-License-Identifier: MIT
#include "pagmo_runs.hpp"

#include "core/check.hpp"

#ifdef SHIGUSA_HAS_PAGMO

#include <algorithm>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <thread>

#include "goal_search.hpp"

namespace shigusa::bench {
namespace {

constexpr unsigned kGenerations = 1U << 20;  // more than any budget lasts for
constexpr unsigned kPopulation = 20;         // pagmo's own examples take it; 7 is the least for DE

// Scores one point of each of several runs in one call, as soon as all active runs have one
// pending.
class SideBySide {
 public:
  SideBySide(const SearchProblem& problem, int runs)
      : problem_(problem), going_(runs), points_(static_cast<std::size_t>(runs)) {}

  double score(std::size_t run, const std::vector<double>& point) {
    std::unique_lock lock(mutex_);
    points_[run] = point;
    waiting_.push_back(run);
    scores_.resize(points_.size());
    if (static_cast<int>(waiting_.size()) == going_) {
      score_waiting();
    } else {
      const int round = round_;
      scored_.wait(lock, [&] { return round_ != round; });
    }
    return scores_[run];
  }

  // Ends a run.
  void leave() {
    const std::scoped_lock lock(mutex_);
    --going_;
    if (going_ > 0 && static_cast<int>(waiting_.size()) == going_) score_waiting();
  }

 private:
  void score_waiting() {
    batch_.clear();
    for (const std::size_t run : waiting_) {
      batch_.insert(batch_.end(), points_[run].begin(), points_[run].end());
    }
    batch_scores_.assign(waiting_.size(), std::numeric_limits<double>::infinity());
    problem_.evaluate(batch_, batch_scores_);
    for (std::size_t k = 0; k < waiting_.size(); ++k) scores_[waiting_[k]] = batch_scores_[k];
    waiting_.clear();
    ++round_;
    scored_.notify_all();
  }

  const SearchProblem& problem_;
  std::mutex mutex_;
  std::condition_variable scored_;
  int going_;
  int round_ = 0;
  std::vector<std::vector<double>> points_;  // (runs)
  std::vector<double> scores_;               // (runs)
  std::vector<std::size_t> waiting_;         // runs
  std::vector<double> batch_;
  std::vector<double> batch_scores_;
};

struct BudgetUsed {};

// State shared by all copies of pagmo's problem: a run's index in SideBySide, and its best scores.
struct Run {
  SideBySide* scorer = nullptr;
  std::size_t number = 0;
  int genes = 0;
  int left = 0;
  BestAt best;
};

struct UnitCube {
  Run* run = nullptr;

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    if (run->left-- <= 0) throw BudgetUsed{};
    pagmo::vector_double inside = x;
    for (double& coordinate : inside) coordinate = std::clamp(coordinate, 0.0, 1.0);
    const double score = run->scorer->score(run->number, inside);
    run->best.note(score);
    return {score};
  }
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const auto genes = static_cast<std::size_t>(run->genes);
    return {pagmo::vector_double(genes, 0.0), pagmo::vector_double(genes, 1.0)};
  }
  // pagmo serialises problems; these are never serialised
  template <class Archive>
  void serialize(Archive&, unsigned) {}
};

pagmo::algorithm algorithm_of(const std::string& name, unsigned seed) {
  if (name == "DE") return pagmo::algorithm{pagmo::de(kGenerations, .8, .9, 2U, 1e-6, 1e-6, seed)};
  if (name == "SADE") {
    return pagmo::algorithm{pagmo::sade(kGenerations, 2U, 1U, 1e-6, 1e-6, false, seed)};
  }
  if (name == "SGA") {
    return pagmo::algorithm{pagmo::sga(kGenerations, .90, 1., 0.02, 1., 2U, "exponential",
                                       "polynomial", "tournament", seed)};
  }
  SHG_CHECK(name == "CMA-ES", "no such search of pagmo: " + name);
  // points are clamped to the cube, as for all other searches
  return pagmo::algorithm{
      pagmo::cmaes(kGenerations, -1, -1, -1, -1, 0.5, 1e-6, 1e-6, false, true, seed)};
}

void evolve(const std::string& name, const SearchProblem& searched, Run& run) {
  for (unsigned restart = 0; run.left > 0; ++restart) {
    const auto seed = static_cast<unsigned>(run.number + 1) + 1000U * restart;
    try {
      pagmo::population population(pagmo::problem{UnitCube{&run}}, 0U, seed);
      if (restart == 0) population.push_back(searched.start);
      while (population.size() < kPopulation)
        population.push_back(population.random_decision_vector());
      (void)algorithm_of(name, seed).evolve(population);
    } catch (const BudgetUsed&) {
      break;
    }
  }
  run.scorer->leave();
}

}  // namespace

std::span<const std::string> pagmo_searches() {
  static const std::string kNames[] = {"CMA-ES", "DE", "SADE", "SGA"};
  return kNames;
}

std::vector<std::vector<double>> run_pagmo(const std::string& name, const SearchProblem& problem,
                                           int seeds, const std::vector<int>& budgets) {
  SideBySide scorer(problem, seeds);
  std::vector<Run> runs;
  for (int s = 0; s < seeds; ++s) {
    runs.push_back(
        {&scorer, static_cast<std::size_t>(s), problem.genes, budgets.back(), BestAt(budgets)});
  }
  {
    std::vector<std::jthread> threads;
    for (Run& run : runs) threads.emplace_back([&] { evolve(name, problem, run); });
  }
  std::vector<std::vector<double>> best;
  for (const Run& run : runs) best.push_back(run.best.best());
  return best;
}

}  // namespace shigusa::bench

#else

namespace shigusa::bench {

std::span<const std::string> pagmo_searches() { return {}; }

std::vector<std::vector<double>> run_pagmo(const std::string&, const SearchProblem&, int,
                                           const std::vector<int>&) {
  fail_check("this program was built without pagmo", "run_pagmo");
}

}  // namespace shigusa::bench

#endif
