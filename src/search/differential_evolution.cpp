// SPDX-License-Identifier: MIT
#include "search/differential_evolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>
#include <utility>

#include "core/check.hpp"
#include "population.hpp"
#include "scorer.hpp"

namespace shigusa {
namespace {

constexpr double kRedrawn = 0.1;         // probability of a new F, and of a new CR
constexpr double kLeastFactor = 0.1;     // F
constexpr double kBestShare = 0.1;       // share of the population from which b is drawn
constexpr double kFirstFactor = 0.5;     // F
constexpr double kFirstCrossover = 0.9;  // CR

struct Rates {
  double factor = kFirstFactor;        // F
  double crossover = kFirstCrossover;  // CR
};

class Evolution {
 public:
  Evolution(const SearchProblem& problem, const DifferentialEvolutionSettings& settings,
            const Progress& progress)
      : scorer_(problem, settings.evaluations, progress),
        random_(settings.seed),
        precision_(settings.precision),
        genes_(static_cast<std::size_t>(problem.genes)),
        count_(static_cast<std::size_t>(settings.population)),
        points_(genes_ * count_),
        scores_(count_),
        trials_(points_),
        trial_scores_(count_) {}

  SearchResult search() {
    bool going = populate(true);
    while (going) going = converged() ? populate(false) : generation();
    for (std::size_t i = 0; i < known_; ++i) {
      const std::span<const double> point = point_of(points_, i, genes_);
      scorer_.result().final_population.push_back({{point.begin(), point.end()}, scores_[i]});
    }
    return std::move(scorer_.result());
  }

 private:
  bool populate(bool first) {
    for (double& x : points_) x = random_.uniform();
    if (first) set_point(points_, 0, scorer_.start());
    rates_.assign(count_, {});
    const int before = scorer_.left();
    const bool going = scorer_.step(points_, scores_);
    known_ = static_cast<std::size_t>(before - scorer_.left());
    return going;
  }

  [[nodiscard]] bool converged() const {
    const auto [best, worst] = std::minmax_element(scores_.begin(), scores_.end());
    return *worst == *best || *worst - *best <= precision_;
  }

  bool generation() {
    const std::vector<std::size_t> order = ranked(scores_);
    std::vector<Rates> rates = rates_;
    for (std::size_t i = 0; i < count_; ++i) {
      if (random_.chance(kRedrawn)) rates[i].factor = random_.uniform(kLeastFactor, 1.0);
      if (random_.chance(kRedrawn)) rates[i].crossover = random_.uniform();
      make_trial(i, rates[i], order);
    }
    const bool going = scorer_.step(trials_, trial_scores_);
    // trials that were not scored are worst, and keep their parents
    for (std::size_t i = 0; i < count_; ++i) {
      if (!(trial_scores_[i] <= scores_[i]) || trial_scores_[i] == kWorst) continue;
      set_point(points_, i, point_of(trials_, i, genes_));
      scores_[i] = trial_scores_[i];
      rates_[i] = rates[i];
    }
    if (going) ++scorer_.result().generations;
    return going;
  }

  // A random member of the population other than these.
  std::size_t other_than(std::size_t a, std::size_t b) {
    for (;;) {
      const std::size_t drawn = random_.below(static_cast<std::uint32_t>(count_));
      if (drawn != a && drawn != b) return drawn;
    }
  }

  void make_trial(std::size_t i, const Rates& rates, std::span<const std::size_t> order) {
    const double share = kBestShare * static_cast<double>(count_);
    const auto bests = std::max(std::uint32_t{2}, static_cast<std::uint32_t>(share));
    const double* b = &points_[order[random_.below(bests)] * genes_];
    const std::size_t first = other_than(i, i);
    const double* r = &points_[first * genes_];
    const double* s = &points_[other_than(i, first) * genes_];
    const double* x = &points_[i * genes_];
    const std::size_t certain = random_.below(static_cast<std::uint32_t>(genes_));
    for (std::size_t g = 0; g < genes_; ++g) {
      double value = x[g];
      if (random_.chance(rates.crossover) || g == certain) {
        value += rates.factor * (b[g] - x[g]) + rates.factor * (r[g] - s[g]);
        if (value < 0.0) value = 0.5 * x[g];
        if (value > 1.0) value = 0.5 * (1.0 + x[g]);
      }
      trials_[i * genes_ + g] = value;
    }
  }

  Scorer scorer_;
  Random random_;
  double precision_;
  std::size_t genes_;
  std::size_t count_;
  std::vector<double> points_;  // (count × genes)
  std::vector<double> scores_;  // (count)
  std::vector<double> trials_;  // (count × genes)
  std::vector<double> trial_scores_;
  std::vector<Rates> rates_;
  std::size_t known_ = 0;  // number of points scored
};

}  // namespace

SearchResult differential_evolution_search(const SearchProblem& problem,
                                           const DifferentialEvolutionSettings& settings,
                                           const Progress& progress) {
  SHG_CHECK(settings.population >= 4 && settings.population <= 10000,
            fmt::format("population is {}, allowed: 4..10000", settings.population));
  SHG_CHECK(settings.precision >= 0.0 && is_finite(settings.precision),
            fmt::format("precision is {}, allowed: 0 and more", settings.precision));
  // checks the problem before memory is allocated for its genes
  Scorer(problem, settings.evaluations, progress);
  return Evolution(problem, settings, progress).search();
}

SearchResult evolution_by_default(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                                  const Progress& progress) {
  return differential_evolution_search(problem, {.evaluations = evaluations, .seed = seed},
                                       progress);
}

}  // namespace shigusa
