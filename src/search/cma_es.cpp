// SPDX-License-Identifier: MIT
#include "search/cma_es.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>
#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"
#include "population.hpp"

namespace shigusa {
namespace {

constexpr double kLeastSpread = 1e-8;  // spread of a run's points at which it ends
constexpr double kLeastFall = 1e-3;    // of the best score, to keep a run going

void check(const SearchProblem& problem, const CmaEsSettings& s) {
  SHG_CHECK(problem.genes <= kCmaMaxGenes,
            fmt::format("genes is {}, allowed: 1..{}", problem.genes, kCmaMaxGenes));
  SHG_CHECK(s.population == 0 || (s.population >= 4 && s.population <= 10000),
            fmt::format("population is {}, allowed: 0 or 4..10000", s.population));
  SHG_CHECK(s.step >= 1e-6 && s.step <= 1.0, fmt::format("step is {}, allowed: 1e-6..1", s.step));
  SHG_CHECK(s.polish_step >= 1e-6 && s.polish_step <= 1.0,
            fmt::format("polish_step is {}, allowed: 1e-6..1", s.polish_step));
  SHG_CHECK(s.scales.empty() || static_cast<int>(s.scales.size()) == problem.genes,
            fmt::format("{} scales for {} genes", s.scales.size(), problem.genes));
  for (const double scale : s.scales) {
    SHG_CHECK(scale >= 1e-6 && scale <= 1e6,
              fmt::format("a scale is {}, allowed: 1e-6..1e6", scale));
  }
  SHG_CHECK(s.diagonal_until >= 0,
            fmt::format("diagonal_until is {}, allowed: 0 and more", s.diagonal_until));
  SHG_CHECK(s.precision >= 0.0 && is_finite(s.precision),
            fmt::format("precision is {}, allowed: 0 and more", s.precision));
}

int default_population(int genes) {
  const double wanted = 4.0 + 3.0 * natural_log(genes);
  return 16 * (1 + static_cast<int>((wanted - 1e-9) / 16.0));
}

}  // namespace

bool CmaEs::Standstill::reached(double best) {
  const bool falls =
      last_ == kWorst ? best < kWorst : best < last_ - max(precision_, kLeastFall * abs(last_));
  since_ = falls ? 0 : since_ + 1;
  if (falls) last_ = best;
  return since_ > patience_;
}

CmaEs::CmaEs(const SearchProblem& problem, const CmaEsSettings& settings, const Progress& progress)
    : settings_(settings),
      scorer_(problem, settings.evaluations, progress),
      random_(settings.seed, settings.stream) {
  check(problem, settings);
  if (settings_.population == 0) settings_.population = default_population(problem.genes);
  scores_.resize(index(settings_.population));
}

bool CmaEs::run_to(int evaluations) {
  while (!over_ && scorer_.result().evaluations < evaluations) {
    if (!descent_) begin_descent();
    step();
  }
  return !over_;
}

SearchResult CmaEs::take_result() {
  SearchResult& result = scorer_.result();
  if (descent_) end_descent();
  for (std::size_t i = 0; i < last_scores_.size(); ++i) {
    const auto point = point_of(last_points_, i, index(scorer_.genes()));
    result.final_population.push_back({{point.begin(), point.end()}, last_scores_[i]});
  }
  return std::move(result);
}

// Begins a descent: from the best point if such descents have had fewer evaluations than all
// others.
void CmaEs::begin_descent() {
  const bool first = descents_++ == 0;
  const int spent = scorer_.result().evaluations;
  const bool polishes = !first && spent - elsewhere_ < elsewhere_;
  std::vector<double> mean;
  if (polishes) {
    mean = scorer_.result().best_seen.point;
  } else if (first) {
    mean = scorer_.start();
  } else {
    for (int k = 0; k < scorer_.genes(); ++k) mean.push_back(random_.uniform());
  }
  const double step = polishes ? settings_.polish_step : settings_.step;
  CmaRun run(std::move(mean), step, settings_.population, CmaShape::diagonal);
  if (first && !settings_.scales.empty()) run.scale(settings_.scales);
  descent_.emplace(
      Descent{.run = std::move(run),
              .standstill =
                  Standstill(settings_.precision, 10 + 12 * scorer_.genes() / settings_.population),
              .begun_at = spent,
              .polishes = polishes,
              .mean_first = first});
}

// One generation.
void CmaEs::step() {
  Descent& now = *descent_;
  if (scorer_.result().evaluations >= settings_.diagonal_until) now.run.learn_whole();
  const std::vector<double>& points = now.run.sample(random_, settings_.mirrored);
  if (std::exchange(now.mean_first, false)) now.run.put_mean_first();
  const int before = scorer_.left();
  over_ = !scorer_.step(points, scores_);
  const std::size_t scored = index(before - scorer_.left());
  keep_best(now.best, std::span(points).first(scored * index(scorer_.genes())),
            std::span(scores_).first(scored), 1);
  bool ends = scored < scores_.size();
  if (!ends) {
    if (before != settings_.evaluations) ++scorer_.result().generations;
    last_points_ = points;
    last_scores_ = scores_;
    now.run.update(scores_);
    ends = now.standstill.reached(now.best[0].score) || now.run.degenerate() ||
           now.run.spread() < kLeastSpread;
  }
  if (ends) end_descent();
}

void CmaEs::end_descent() {
  scorer_.result().final_population.push_back(std::move(descent_->best[0]));
  if (!descent_->polishes) elsewhere_ += scorer_.result().evaluations - descent_->begun_at;
  descent_.reset();
}

SearchResult cma_es_search(const SearchProblem& problem, const CmaEsSettings& settings,
                           const Progress& progress) {
  CmaEs search(problem, settings, progress);
  search.run_to(settings.evaluations);
  return search.take_result();
}

SearchResult cma_es_by_default(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                               const Progress& progress) {
  return cma_es_search(problem, {.evaluations = evaluations, .seed = seed}, progress);
}

}  // namespace shigusa
