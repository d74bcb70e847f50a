// SPDX-License-Identifier: MIT
#include "search/random_search.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>
#include <utility>

#include "core/check.hpp"
#include "population.hpp"
#include "scorer.hpp"

namespace shigusa {

SearchResult random_search(const SearchProblem& problem, const RandomSettings& settings,
                           const Progress& progress) {
  SHG_CHECK(settings.batch >= 1 && settings.batch <= 10000,
            fmt::format("batch is {}, allowed: 1..10000", settings.batch));
  SHG_CHECK(settings.keep >= 1 && settings.keep <= 10000,
            fmt::format("keep is {}, allowed: 1..10000", settings.keep));
  Scorer scorer(problem, settings.evaluations, progress);
  Random random(settings.seed);
  const auto genes = static_cast<std::size_t>(problem.genes);
  std::vector<double> points(static_cast<std::size_t>(settings.batch) * genes);
  std::vector<double> scores(static_cast<std::size_t>(settings.batch));
  std::vector<Individual> best;
  for (bool first = true, going = true; going; first = false) {
    for (double& x : points) x = random.uniform();
    if (first && !problem.start.empty()) set_point(points, 0, problem.start);
    const int before = scorer.left();
    going = scorer.step(points, scores);
    const auto scored = static_cast<std::size_t>(before - scorer.left());
    keep_best(best, std::span(points).first(scored * genes), std::span(scores).first(scored),
              static_cast<std::size_t>(settings.keep));
    if (!first) ++scorer.result().generations;
  }
  scorer.result().final_population = std::move(best);
  return std::move(scorer.result());
}

SearchResult random_by_default(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                               const Progress& progress) {
  return random_search(problem, {.evaluations = evaluations, .seed = seed}, progress);
}

}  // namespace shigusa
