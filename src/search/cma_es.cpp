// SPDX-License-Identifier: MIT
#include "search/cma_es.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <shigusa/random.hpp>
#include <shigusa/scalar.hpp>
#include <shigusa/search.hpp>
#include <utility>

#include "cma_run.hpp"
#include "core/check.hpp"
#include "population.hpp"
#include "scorer.hpp"

namespace shigusa {
namespace {

constexpr double kLeastSpread = 1e-8;  // where a run's points lie so close, it is over
constexpr double kLeastFall = 1e-3;    // of the best score, that keeps a run going

void check(const SearchProblem& problem, const CmaEsSettings& s) {
  SHG_CHECK(problem.genes <= kCmaMaxGenes,
            fmt::format("genes is {}, allowed: 1..{}", problem.genes, kCmaMaxGenes));
  SHG_CHECK(s.population == 0 || (s.population >= 4 && s.population <= 10000),
            fmt::format("population is {}, allowed: 0 or 4..10000", s.population));
  SHG_CHECK(s.step >= 1e-6 && s.step <= 1.0, fmt::format("step is {}, allowed: 1e-6..1", s.step));
  SHG_CHECK(s.polish_step >= 1e-6 && s.polish_step <= 1.0,
            fmt::format("polish_step is {}, allowed: 1e-6..1", s.polish_step));
  SHG_CHECK(s.precision >= 0.0 && is_finite(s.precision),
            fmt::format("precision is {}, allowed: 0 and more", s.precision));
}

int default_population(int genes) {
  const double wanted = 4.0 + 3.0 * natural_log(genes);
  return 16 * (1 + static_cast<int>((wanted - 1e-9) / 16.0));
}

// Tells when the best of a run has stopped falling.
class Standstill {
 public:
  Standstill(double precision, int patience) : precision_(precision), patience_(patience) {}

  [[nodiscard]] bool reached(double best) {
    const bool falls =
        last_ == kWorst ? best < kWorst : best < last_ - max(precision_, kLeastFall * abs(last_));
    since_ = falls ? 0 : since_ + 1;
    if (falls) last_ = best;
    return since_ > patience_;
  }

 private:
  double precision_;
  int patience_;  // generations
  double last_ = kWorst;
  int since_ = 0;  // generations
};

class CmaEs {
 public:
  CmaEs(const SearchProblem& problem, const CmaEsSettings& settings, const Progress& progress)
      : settings_(settings),
        scorer_(problem, settings.evaluations, progress),
        random_(settings.seed) {
    check(problem, settings);
    if (settings_.population == 0) settings_.population = default_population(problem.genes);
  }

  SearchResult search() {
    int elsewhere = 0;  // evaluations of the runs that did not begin at the best
    bool going = true;
    for (int run = 0; going; ++run) {
      const int spent = scorer_.result().evaluations;
      const bool polishes = run > 0 && spent - elsewhere < elsewhere;
      if (polishes) {
        going = descend(scorer_.result().best_seen.point, settings_.polish_step, false);
      } else {
        going = descend(run == 0 ? scorer_.start() : random_point(), settings_.step, run == 0);
        elsewhere += scorer_.result().evaluations - spent;
      }
    }
    for (std::size_t i = 0; i < last_scores_.size(); ++i) {
      const auto point = point_of(last_points_, i, static_cast<std::size_t>(scorer_.genes()));
      scorer_.result().final_population.push_back({{point.begin(), point.end()}, last_scores_[i]});
    }
    return std::move(scorer_.result());
  }

 private:
  std::vector<double> random_point() {
    std::vector<double> point(static_cast<std::size_t>(scorer_.genes()));
    for (double& x : point) x = random_.uniform();
    return point;
  }

  // One run; false when the search must end with it.
  bool descend(std::vector<double> mean, double step, bool mean_first) {
    CmaRun run(std::move(mean), step, settings_.population);
    Standstill standstill(settings_.precision, 10 + 12 * scorer_.genes() / settings_.population);
    std::vector<Individual> best;
    std::vector<double> scores(static_cast<std::size_t>(settings_.population));
    bool going = true;
    for (bool over = false; going && !over; mean_first = false) {
      const std::vector<double>& points = run.sample(random_);
      if (mean_first) run.put_mean_first();
      const int before = scorer_.left();
      going = scorer_.step(points, scores);
      const auto scored = static_cast<std::size_t>(before - scorer_.left());
      keep_best(best, std::span(points).first(scored * points.size() / scores.size()),
                std::span(scores).first(scored), 1);
      if (scored < scores.size()) break;
      if (before != settings_.evaluations) ++scorer_.result().generations;
      last_points_ = points;
      last_scores_ = scores;
      run.update(scores);
      over = standstill.reached(best[0].score) || run.degenerate() || run.spread() < kLeastSpread;
    }
    scorer_.result().final_population.push_back(std::move(best[0]));
    return going;
  }

  CmaEsSettings settings_;
  Scorer scorer_;
  Random random_;
  std::vector<double> last_points_;  // of the last generation that was scored as a whole
  std::vector<double> last_scores_;
};

}  // namespace

SearchResult cma_es_search(const SearchProblem& problem, const CmaEsSettings& settings,
                           const Progress& progress) {
  return CmaEs(problem, settings, progress).search();
}

SearchResult cma_es_by_default(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                               const Progress& progress) {
  return cma_es_search(problem, {.evaluations = evaluations, .seed = seed}, progress);
}

}  // namespace shigusa
