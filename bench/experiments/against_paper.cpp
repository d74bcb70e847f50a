// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/core/parallel.hpp>
#include <shigusa/hierarchy/generator.hpp>

#include "goal_search.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

constexpr int kBudgets[] = {300, 3000};
constexpr int kLongSearch = 30000;
constexpr double kWanted[] = {0.5, 0.3};  // ratios that the project set out for

struct Found {
  double score = 0.0;
  bool arrived = false;     // its best candidate meets the goal
  bool over_limit = false;  // … and passes a joint limit
};

Found find(const Subject& subject, const Place& place, Preset preset,
           const CriteriaSettings& criteria, int evaluations, std::uint64_t seed) {
  Task task = goal_task(subject.body, place.position, preset, criteria);
  task.genetic.seed = seed;
  task.evaluations = evaluations;
  const Generation generation = generate(task).value();
  const bool arrived = generation.status == ReachStatus::reached;
  return {generation.best_seen_score, arrived,
          arrived && !generation.candidates.front().over_limit.empty()};
}

// All seeds of all places: medians of the scores, and counts.
struct Series {
  std::vector<double> scores;  // (places)
  int runs = 0;
  int arrived = 0;
  int over_limit = 0;
};

int seeds_of(const Plan& plan, int evaluations) {
  if (evaluations == kLongSearch) return 1;
  return evaluations == kBudgets[0] ? plan.seeds : plan.few_seeds;
}

Series run(const Plan& plan, const Subject& subject, Preset preset,
           const CriteriaSettings& criteria, int evaluations) {
  const int seeds = seeds_of(plan, evaluations);
  Series series;
  series.runs = static_cast<int>(subject.places.size()) * seeds;
  std::vector<Found> found(static_cast<std::size_t>(series.runs));
  parallel_for(series.runs, 0, [&](int i, int) {
    found[static_cast<std::size_t>(i)] =
        find(subject, subject.places[static_cast<std::size_t>(i / seeds)], preset, criteria,
             evaluations, static_cast<std::uint64_t>(i % seeds) + 1);
  });
  std::vector<double> of_place;
  for (const Found& one : found) {
    series.arrived += one.arrived ? 1 : 0;
    series.over_limit += one.over_limit ? 1 : 0;
    of_place.push_back(one.score);
    if (static_cast<int>(of_place.size()) < seeds) continue;
    series.scores.push_back(median(of_place));
    of_place.clear();
  }
  return series;
}

std::vector<double> ratios_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return ratios;
}

void add_lines(const Plan& plan, const Subject& subject, const CriteriaPreset& criteria,
               Table& table, Table& named) {
  const Series longest = run(plan, subject, Preset::flat, criteria.settings(), kLongSearch);
  for (std::size_t b = 0; b < std::size(kBudgets); ++b) {
    const Series paper = run(plan, subject, Preset::paper, criteria.settings(), kBudgets[b]);
    const Series flat = run(plan, subject, Preset::flat, criteria.settings(), kBudgets[b]);
    const std::vector<double> ratios = ratios_of(flat.scores, paper.scores);
    std::vector<std::string> cells{std::string(criteria.name), subject.body.name(),
                                   std::to_string(kBudgets[b])};
    std::vector<std::string> line = cells;
    line.insert(line.end(),
                {spread(of_drawn(subject, paper.scores)), spread(of_drawn(subject, flat.scores)),
                 spread(of_drawn(subject, ratios)), fmt::format("≤ {:g}", kWanted[b]),
                 spread(of_drawn(subject, ratios_of(longest.scores, paper.scores))),
                 percent(paper.over_limit, paper.arrived), percent(flat.over_limit, flat.arrived)});
    table.add(line);
    for (std::size_t p = subject.drawn; p < ratios.size(); ++p) {
      cells.push_back(
          fmt::format("{:.3f} / {:.3f} = {:.2f}", flat.scores[p], paper.scores[p], ratios[p]));
    }
    named.add(cells);
  }
}

}  // namespace

std::string against_paper(const Plan& plan, std::span<const Subject> subjects) {
  Table table({"criteria", "body", "motions", "paper", "flat", "flat / paper", "wanted",
               fmt::format("flat after {} / paper", kLongSearch), "paper over a limit",
               "flat over a limit"});
  Table named({"criteria", "body", "motions", "low front-left", "at the feet", "high right"});
  // the paper's and the default; what is left is for fronts
  for (const CriteriaPreset& criteria : criteria_presets().first(2)) {
    for (const Subject& subject : subjects) add_lines(plan, subject, criteria, table, named);
  }
  return fmt::format(
             "`generate()` with the preset `flat` (CMA-ES over logarithmic weights, postures and "
             "path, joint limits kept) and with `paper` (the paper's genetic algorithm over "
             "weights 0..15, restarted until the budget is used up), both scored by the same "
             "criteria. The ratio is that of the best scores that the two saw; motions that miss "
             "the goal count as the worst score. {} seeds at 300 motions, {} at 3000. A search of "
             "{} motions (1 seed) "
             "tells what any could come to. The last columns tell how many of the best candidates "
             "that meet the goal pass a joint limit somewhere on the way.\n\n",
             plan.seeds, plan.few_seeds, kLongSearch) +
         table.text() + "\nThe goals that have names, flat / paper:\n\n" + named.text();
}

}  // namespace shigusa::bench
