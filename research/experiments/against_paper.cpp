// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "goal_search.hpp"
#include "plot.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

// Numbers of motions, and the project's target ratio for them.
struct Budget {
  int motions = 0;
  double wanted = 0.0;  // 0: none
};
constexpr Budget kBudgets[] = {{100}, {300, 0.5}, {1000}, {3000, 0.3}, {10000}};
constexpr int kManyMotions = 3000;  // from here on with few seeds
constexpr int kLongSearch = 30000;

struct Found {
  double score = 0.0;
  double milliseconds = 0.0;
  bool arrived = false;     // its best candidate meets the goal
  bool over_limit = false;  // … and passes a joint limit
};

Found find(const Task& task) {
  const Stopwatch watch;
  const GenerateResult generation = generate(task).value();
  const double milliseconds = watch.milliseconds();
  const bool arrived = generation.meets_goals();
  return {generation.best_seen_score, milliseconds, arrived,
          arrived && !generation.candidates.front().measures.over_limit.empty()};
}

// All seeds of all places: medians of the scores, and counts.
struct Series {
  std::vector<double> scores;        // (places)
  std::vector<double> milliseconds;  // (places) a query
  int runs = 0;
  int arrived = 0;
  int over_limit = 0;
};

// `motions`: evaluations per place.
Series run(int seeds, const Subject& subject, Preset preset, const CriteriaSettings& criteria,
           const std::function<int(std::size_t place)>& motions) {
  Series series;
  series.runs = static_cast<int>(subject.places.size()) * seeds;
  std::vector<Found> found(static_cast<std::size_t>(series.runs));
  parallel_for(series.runs, 0, [&](int i, int) {
    const auto place = static_cast<std::size_t>(i / seeds);
    Task task = goal_task(subject.posed, subject.places[place].position, preset, criteria);
    task.seed = static_cast<std::uint64_t>(i % seeds) + 1;
    task.evaluations = motions(place);
    found[static_cast<std::size_t>(i)] = find(task);
  });
  std::vector<double> of_place;
  std::vector<double> times;
  for (const Found& one : found) {
    series.arrived += one.arrived ? 1 : 0;
    series.over_limit += one.over_limit ? 1 : 0;
    of_place.push_back(one.score);
    times.push_back(one.milliseconds);
    if (static_cast<int>(of_place.size()) < seeds) continue;
    series.scores.push_back(median(of_place));
    series.milliseconds.push_back(median(times));
    of_place.clear();
    times.clear();
  }
  return series;
}

std::vector<double> ratios_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return ratios;
}

std::string ratio_of(const Subject& subject, const Series& series, const Series& paper) {
  return spread(of_drawn(subject, ratios_of(series.scores, paper.scores)));
}

struct Tables {
  Table all;
  Table named;  // of the goals that have names
};

void add_lines(const Plan& plan, const Subject& subject, const CriteriaPreset& criteria,
               Tables& tables, std::vector<PlotSeries>& dots) {
  const CriteriaSettings settings = criteria.settings();
  const Series longest =
      run(1, subject, Preset::flat, settings, [](std::size_t) { return kLongSearch; });
  for (const Budget& budget : kBudgets) {
    const auto motions = [&](std::size_t) { return budget.motions; };
    const int seeds = budget.motions >= kManyMotions ? plan.few_seeds : plan.seeds;
    const Series paper = run(seeds, subject, Preset::paper, settings, motions);
    const Series flat = run(seeds, subject, Preset::flat, settings, motions);
    // at the speed of the measured queries
    const Series in_time = run(plan.few_seeds, subject, Preset::flat, settings, [&](std::size_t p) {
      const double share = paper.milliseconds[p] / flat.milliseconds[p];
      return std::max(kPaperPopulation, static_cast<int>(budget.motions * share));
    });
    const std::vector<double> ratios = ratios_of(flat.scores, paper.scores);
    std::vector<std::string> cells{std::string(criteria.name), subject.posed.body.name(),
                                   std::to_string(budget.motions)};
    std::vector<std::string> line = cells;
    line.insert(line.end(),
                {spread(of_drawn(subject, paper.scores)), spread(of_drawn(subject, flat.scores)),
                 spread(of_drawn(subject, ratios)),
                 budget.wanted > 0.0 ? fmt::format("≤ {:g}", budget.wanted) : "",
                 ratio_of(subject, in_time, paper), ratio_of(subject, longest, paper),
                 fmt::format("{:.1f}", median(paper.milliseconds)),
                 fmt::format("{:.1f}", median(flat.milliseconds)),
                 percent(paper.over_limit, paper.arrived), percent(flat.over_limit, flat.arrived)});
    tables.all.add(line);
    for (std::size_t p = subject.drawn; p < ratios.size(); ++p) {
      cells.push_back(
          fmt::format("{:.3f} / {:.3f} = {:.2f}", flat.scores[p], paper.scores[p], ratios[p]));
    }
    tables.named.add(cells);
    if (budget.wanted == 0.0) continue;
    dots.push_back({fmt::format("{}, {} motions", subject.posed.body.name(), budget.motions),
                    of_drawn(subject, paper.scores), of_drawn(subject, flat.scores)});
  }
}

}  // namespace

std::string against_paper(const Plan& plan, std::span<const Subject> subjects,
                          std::vector<Picture>& pictures) {
  Tables tables{
      Table({"criteria", "body", "motions", "paper", "flat", "flat / paper", "wanted",
             "flat / paper in equal time", fmt::format("flat after {} / paper", kLongSearch),
             "paper, ms", "flat, ms", "paper over a limit", "flat over a limit"}),
      Table({"criteria", "body", "motions", "low front-left", "at the feet", "high right"})};
  std::string images;
  // the paper's and the default; the others are for Pareto fronts
  for (const CriteriaPreset& criteria : criteria_presets().first(2)) {
    std::vector<PlotSeries> dots;
    for (const Subject& subject : subjects) add_lines(plan, subject, criteria, tables, dots);
    const std::string name = "paper_" + std::string(criteria.name) + "_criteria";
    const std::vector<double> ticks{0.05, 0.1, 0.2, 0.3, 0.5, 1, 2};
    pictures.push_back({name, dot_plot({"the preset paper's best score, " +
                                            std::string(criteria.name) + " criteria, a dot a goal",
                                        ticks},
                                       {"the preset flat's best score", ticks}, dots,
                                       {{"as good", 1.0}, {"half", 0.5}, {"0.3", 0.3}})});
    images += fmt::format(
        "\n![Best scores of flat and paper by the {} criteria]"
        "(images/experiments/{}.svg)\n",
        criteria.name, name);
  }
  return fmt::format(
             "`generate()` with the preset `flat` (CMA-ES over logarithmic weights, postures and "
             "path, joint limits kept) and with `paper` (the paper's genetic algorithm over "
             "weights 0..15, restarted until the budget is used up), both scored by the same "
             "criteria. The ratio is that of the best scores that the two saw; motions that miss "
             "the goal count as the worst score. {} seeds, {} from {} motions on. A search of {} "
             "motions (1 seed) "
             "tells what any could come to. The last columns tell how many of the best candidates "
             "that meet the goal pass a joint limit somewhere on the way. In equal time, flat "
             "scores as many motions as paper's whole "
             "query takes time for, at flat's speed ({} seeds); times are those of whole queries "
             "on one thread.\n\n",
             plan.seeds, plan.few_seeds, kManyMotions, kLongSearch, plan.few_seeds) +
         tables.all.text() + images + "\nThe goals that have names, flat / paper:\n\n" +
         tables.named.text();
}

}  // namespace shigusa::bench
