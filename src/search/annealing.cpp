// SPDX-License-Identifier: MIT
#include "search/annealing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>
#include <utility>

#include "core/check.hpp"
#include "normal.hpp"
#include "population.hpp"
#include "scorer.hpp"

namespace shigusa {
namespace {

constexpr double kMovedGenes = 3.0;  // expected number of coordinates changed by a move

void check(const AnnealingSettings& s) {
  SHG_CHECK(s.chains >= 2 && s.chains <= 10000,
            fmt::format("chains is {}, allowed: 2..10000", s.chains));
  SHG_CHECK(s.first_cycle >= 1 && s.first_cycle <= 1000000,
            fmt::format("first_cycle is {}, allowed: 1..1000000", s.first_cycle));
  SHG_CHECK(s.first_step >= 1e-6 && s.first_step <= 1.0,
            fmt::format("first_step is {}, allowed: 1e-6..1", s.first_step));
  SHG_CHECK(s.last_step >= 1e-6 && s.last_step <= s.first_step,
            fmt::format("last_step is {}, allowed: 1e-6..first_step", s.last_step));
  SHG_CHECK(s.hot >= 1e-6 && s.hot <= 1e6, fmt::format("hot is {}, allowed: 1e-6..1e6", s.hot));
  SHG_CHECK(s.cooling >= 1e-12 && s.cooling <= 1.0,
            fmt::format("cooling is {}, allowed: 1e-12..1", s.cooling));
}

// Interquartile range of the scores; 1 if it is 0 or not finite.
double spread_of(std::span<const double> scores) {
  const std::vector<std::size_t> order = ranked(scores);
  const double spread = scores[order[order.size() * 3 / 4]] - scores[order[order.size() / 4]];
  return is_finite(spread) && spread > 0.0 ? spread : 1.0;
}

class Annealing {
 public:
  Annealing(const SearchProblem& problem, const AnnealingSettings& settings,
            const Progress& progress)
      : settings_(settings),
        scorer_(problem, settings.evaluations, progress),
        random_(settings.seed),
        genes_(static_cast<std::size_t>(problem.genes)),
        count_(static_cast<std::size_t>(settings.chains)),
        points_(genes_ * count_),
        scores_(count_),
        moved_(points_),
        moved_scores_(count_),
        best_points_(points_),
        best_scores_(count_, kWorst) {}

  SearchResult search() {
    for (double& x : points_) x = random_.uniform();
    set_point(points_, 0, scorer_.start());
    const int all = scorer_.left();
    bool going = scorer_.step(points_, scores_);
    const auto known = std::min(count_, static_cast<std::size_t>(all));
    best_points_ = points_;
    best_scores_ = scores_;
    const double hot = settings_.hot * spread_of(scores_);
    for (double steps = settings_.first_cycle; going; steps *= 2.0) going = cool(hot, steps);
    for (std::size_t i = 0; i < known; ++i) {
      const std::span<const double> point = point_of(best_points_, i, genes_);
      scorer_.result().final_population.push_back({{point.begin(), point.end()}, best_scores_[i]});
    }
    return std::move(scorer_.result());
  }

 private:
  // Runs one cycle; false when the search must end.
  bool cool(double hot, double steps) {
    const double log_cooling = natural_log(settings_.cooling);
    const double log_narrowing = natural_log(settings_.last_step / settings_.first_step);
    for (double s = 0.0; s < steps; s += 1.0) {
      const double share = (s + 1.0) / steps;
      const double width = settings_.first_step * exponential(share * log_narrowing);
      if (!step(hot * exponential(share * log_cooling), width)) return false;
    }
    const Individual& best = scorer_.result().best_seen;
    for (std::size_t i = 0; i < count_; i += 2) {
      set_point(points_, i, best.point);
      scores_[i] = best.score;
    }
    return true;
  }

  bool step(double temperature, double width) {
    moved_ = points_;
    for (std::size_t i = 0; i < count_; ++i)
      move(std::span(moved_).subspan(i * genes_, genes_), width);
    const bool going = scorer_.step(moved_, moved_scores_);
    for (std::size_t i = 0; i < count_; ++i) {
      // drawn for each chain, so that random numbers do not depend on other chains' scores
      const double drawn = random_.uniform();
      const double increase = moved_scores_[i] - scores_[i];
      if (moved_scores_[i] == kWorst && scores_[i] < kWorst) continue;
      if (increase > 0.0 && drawn >= exponential(-increase / temperature)) continue;
      set_point(points_, i, point_of(moved_, i, genes_));
      scores_[i] = moved_scores_[i];
      if (scores_[i] >= best_scores_[i]) continue;
      set_point(best_points_, i, point_of(moved_, i, genes_));
      best_scores_[i] = scores_[i];
    }
    if (going) ++scorer_.result().generations;
    return going;
  }

  void move(std::span<double> point, double width) {
    const std::size_t certain = random_.below(static_cast<std::uint32_t>(genes_));
    const double rate = kMovedGenes / static_cast<double>(genes_);
    for (std::size_t g = 0; g < genes_; ++g) {
      if (!random_.chance(rate) && g != certain) continue;
      point[g] = reflected(point[g] + width * normal(random_));
    }
  }

  AnnealingSettings settings_;
  Scorer scorer_;
  Random random_;
  std::size_t genes_;
  std::size_t count_;
  std::vector<double> points_;  // (count × genes) present points of the chains
  std::vector<double> scores_;
  std::vector<double> moved_;  // (count × genes) proposed points
  std::vector<double> moved_scores_;
  std::vector<double> best_points_;  // (count × genes) the best of each chain
  std::vector<double> best_scores_;
};

}  // namespace

SearchResult annealing_search(const SearchProblem& problem, const AnnealingSettings& settings,
                              const Progress& progress) {
  check(settings);
  // checks the problem before memory is allocated for its genes
  Scorer(problem, settings.evaluations, progress);
  return Annealing(problem, settings, progress).search();
}

SearchResult annealing_by_default(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                                  const Progress& progress) {
  return annealing_search(problem, {.evaluations = evaluations, .seed = seed}, progress);
}

}  // namespace shigusa
