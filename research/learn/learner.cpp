// SPDX-License-Identifier: MIT
#include "learner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "search/cma_es.hpp"

namespace shigusa::bench {
namespace {

constexpr std::uint64_t kOtherSeed = 1000;
constexpr std::size_t kGeneration = 16;  // points of which the middle is taken, at most

// Evaluates the points of a search, one generation at a time.
class Learner {
 public:
  Learner(const std::vector<Unit>& units, const LearnSettings& settings)
      : train_(part_of(units, false)),
        held_(part_of(units, true)),
        settings_(settings),
        space_(settings.start, settings.scales) {}

  [[nodiscard]] SearchProblem problem() {
    SearchProblem problem;
    problem.genes = space_.genes();
    problem.start = space_.point(settings_.start);
    problem.evaluate = [this](std::span<const double> points, std::span<double> scores) {
      score(points, scores);
    };
    return problem;
  }

  // The better of two points on the training set, with other random numbers.
  [[nodiscard]] CriteriaSettings better(std::span<const double> one,
                                        std::span<const double> other) const {
    const CriteriaSettings two[] = {space_.mixture(one), space_.mixture(other)};
    const auto again = measure(train_, two, other_seed(settings_.measure));
    std::cout << fmt::format("best seen {:.4f}, middle {:.4f}\n", again[0].loss, again[1].loss);
    return again[1].loss < again[0].loss ? two[1] : two[0];
  }

 private:
  void score(std::span<const double> points, std::span<double> scores) {
    const auto genes = static_cast<std::size_t>(space_.genes());
    std::vector<CriteriaSettings> mixtures;
    for (std::size_t i = 0; i < scores.size(); ++i) {
      mixtures.push_back(space_.mixture(points.subspan(i * genes, genes)));
    }
    const auto all = measure(train_, mixtures, settings_.measure);
    std::transform(all.begin(), all.end(), scores.begin(),
                   [](const Measured& m) { return m.loss; });
    const auto best =
        static_cast<std::size_t>(std::min_element(scores.begin(), scores.end()) - scores.begin());
    const auto out = measure(held_, {&mixtures[best], 1}, settings_.measure);
    scored_ += scores.size();
    std::cout << fmt::format("{} training {:.4f} held out {:.4f} jolting {:.2f} {}\n", scored_,
                             scores[best], out[0].loss, all[best].jolting,
                             weights_text(mixtures[best]))
              << std::flush;
  }

  std::vector<const Unit*> train_;
  std::vector<const Unit*> held_;
  const LearnSettings& settings_;
  MixtureSpace space_;
  std::size_t scored_ = 0;
};

std::vector<double> middle_of(std::span<const Individual> points) {
  std::vector<double> middle(points.front().point.size());
  for (const Individual& each : points) {
    for (std::size_t g = 0; g < middle.size(); ++g) {
      middle[g] += each.point[g] / static_cast<double>(points.size());
    }
  }
  return middle;
}

}  // namespace

MeasureSettings other_seed(MeasureSettings settings) {
  settings.seed += kOtherSeed;
  return settings;
}

CriteriaSettings learned(const std::vector<Unit>& units, const LearnSettings& settings) {
  Learner learner(units, settings);
  const SearchProblem problem = learner.problem();
  const SearchResult found = cma_es_search(
      problem,
      {.evaluations = settings.evaluations, .step = settings.step, .seed = settings.measure.seed});
  const std::span<const Individual> points(found.final_population);
  const std::span<const Individual> last = points.last(std::min(points.size(), kGeneration));
  return learner.better(found.best_seen.point, middle_of(last));
}

}  // namespace shigusa::bench
