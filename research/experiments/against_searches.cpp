// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>

#include "goal_search.hpp"
#include "pagmo_runs.hpp"
#include "plot.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

const std::vector<int> kBudgets{100, 300, 1000, 3000, 10000};
// points of the plot's lines
const std::vector<int> kPoints{60,  80,   100,  140,  200,  300,  420,  600,
                               800, 1000, 1400, 2000, 3000, 4500, 7000, 10000};

// A search method: ours on a code, or one of pagmo's.
struct Searcher {
  std::string name;
  std::optional<SearchMethod> ours{};
  GeneCode code = GeneCode::natural;
};

std::vector<Searcher> searchers() {
  std::vector<Searcher> all{
      {"cma_es", SearchMethod::cma_es},
      {"de", SearchMethod::differential_evolution},
      {"annealing", SearchMethod::annealing},
      {"log_ga", SearchMethod::log_ga},
      {"paper_ga, the paper's 16 weights", SearchMethod::paper_ga, GeneCode::paper},
      {"random", SearchMethod::random}};
  for (const std::string& name : pagmo_searches()) all.push_back({name});
  return all;
}

// Result of one search at one place.
struct Run {
  std::vector<double> best;   // (points) the median over the seeds
  double microseconds = 0.0;  // a motion, with the search's own work; 0 of pagmo's
};

Run run(const Searcher& searcher, const Plan& plan, const PosedBody& posed, const Vec3d& goal) {
  GoalSearch searched(posed, goal, {.code = searcher.code});
  const SearchProblem problem = searched.problem();
  std::vector<std::vector<double>> of_seeds;
  Run of_place;
  if (searcher.ours) {
    const Stopwatch watch;
    for (int seed = 1; seed <= plan.seeds; ++seed) {
      BestAt best(kPoints);
      (void)search(*searcher.ours, best.watch(problem), kPoints.back(),
                   static_cast<std::uint64_t>(seed));
      of_seeds.push_back(best.best());
    }
    of_place.microseconds = 1e3 * watch.milliseconds() / plan.seeds / kPoints.back();
  } else {
    of_seeds = run_pagmo(searcher.name, problem, plan.seeds, kPoints);
  }
  for (std::size_t b = 0; b < kPoints.size(); ++b) {
    std::vector<double> scores;
    for (const std::vector<double>& one : of_seeds) scores.push_back(one[b]);
    of_place.best.push_back(median(scores));
  }
  return of_place;
}

// [searcher](places)
using Runs = std::vector<std::vector<Run>>;

Runs measure(const Plan& plan, const Subject& subject, const std::vector<Searcher>& all) {
  const std::size_t places = subject.places.size();
  Runs runs(all.size(), std::vector<Run>(places));
  parallel_for(static_cast<int>(all.size() * places), 0, [&](int i, int) {
    const std::size_t s = static_cast<std::size_t>(i) / places;
    const std::size_t p = static_cast<std::size_t>(i) % places;
    runs[s][p] = run(all[s], plan, subject.posed, subject.places[p].position);
  });
  return runs;
}

std::size_t point_of(int budget) {
  const auto at = std::lower_bound(kPoints.begin(), kPoints.end(), budget);
  return static_cast<std::size_t>(at - kPoints.begin());
}

// (drawn places) `value` of each place
template <class Value>
std::vector<double> of_drawn_places(const Subject& subject, Value&& value) {
  std::vector<double> values;
  for (std::size_t p = 0; p < subject.drawn; ++p) values.push_back(value(p));
  return values;
}

// Comparison with cma_es after `budget` motions, at the point nearest to its time.
std::string in_equal_time(const Subject& subject, const Runs& runs, std::size_t s, int budget) {
  if (runs[s][0].microseconds == 0.0) return "";
  const std::size_t b = point_of(budget);
  return fmt::format(
      "{:.3f}", median(of_drawn_places(subject, [&](std::size_t p) {
        const double motions = budget * runs[0][p].microseconds / runs[s][p].microseconds;
        double best = runs[s][p].best[0];
        for (std::size_t k = 0; k < kPoints.size() && kPoints[k] <= 1.1 * motions; ++k) {
          best = runs[s][p].best[k];
        }
        return best / runs[0][p].best[b];
      })));
}

std::string table_of(const Subject& subject, const std::vector<Searcher>& all, const Runs& runs) {
  std::vector<std::string> head{"search"};
  for (const int budget : kBudgets) head.push_back(std::to_string(budget));
  for (const int budget : kBudgets) head.push_back("beside cma_es, " + std::to_string(budget));
  head.insert(head.end(), {"µs a motion", "in cma_es' time for 3000"});
  Table table(head);
  for (std::size_t s = 0; s < all.size(); ++s) {
    std::vector<std::string> cells{(all[s].ours ? "" : "pagmo ") + all[s].name};
    const auto score = [&](std::size_t of, int budget) {
      return [&runs, of, b = point_of(budget)](std::size_t p) { return runs[of][p].best[b]; };
    };
    for (const int budget : kBudgets) {
      cells.push_back(spread(of_drawn_places(subject, score(s, budget))));
    }
    for (const int budget : kBudgets) {
      const auto ours = score(0, budget);
      const auto theirs = score(s, budget);
      const auto ratio = [&](std::size_t p) { return theirs(p) / ours(p); };
      cells.push_back(fmt::format("{:.3f}", median(of_drawn_places(subject, ratio))));
    }
    const double microseconds =
        median(of_drawn_places(subject, [&](std::size_t p) { return runs[s][p].microseconds; }));
    cells.push_back(microseconds > 0.0 ? fmt::format("{:.1f}", microseconds) : "");
    cells.push_back(in_equal_time(subject, runs, s, 3000));
    table.add(cells);
  }
  return table.text();
}

// Excess over the best score of all methods, at the median goal.
std::string picture_of(const Subject& subject, const std::vector<Searcher>& all, const Runs& runs) {
  std::vector<PlotSeries> lines;
  for (std::size_t s = 0; s < all.size(); ++s) {
    PlotSeries line{
        (all[s].ours ? "" : "pagmo ") + all[s].name.substr(0, all[s].name.find(',')), {}, {}};
    for (std::size_t k = 0; k < kPoints.size(); ++k) {
      line.x.push_back(kPoints[k]);
      line.y.push_back(median(of_drawn_places(subject, [&](std::size_t p) {
        double least = runs[0][p].best.back();
        for (const std::vector<Run>& one : runs) least = std::min(least, one[p].best.back());
        return runs[s][p].best[k] / least;
      })));
    }
    lines.push_back(std::move(line));
  }
  return line_plot({"motions scored", {60, 100, 300, 1000, 3000, 10000}},
                   {"best score / the best of all searches", {1, 1.2, 1.5, 2, 3}}, lines);
}

}  // namespace

std::string against_searches(const Plan& plan, std::span<const Subject> subjects,
                             std::vector<Picture>& pictures) {
  const std::vector<Searcher> all = searchers();
  std::string page = fmt::format(
      "Every search minimises the same SearchProblem from one start: the parameters of the preset "
      "flat, the default criteria, limits kept, one hand path; `paper_ga` alone has another space, "
      "the paper's weights, on the same motions and scores. Best score after "
      "motions, {} seeds{}. Beside cma_es: the median over the goals of the ratio to the default's "
      "score on that goal; above 1 is worse. pagmo's have their own defaults, a population of 20 "
      "with the start among it, the cube's faces enforced, and start again when they converge; "
      "they score one point at a time, so time is not compared. The last column is the search's "
      "own score after the time that cma_es takes for 3000 motions, beside cma_es'.\n",
      plan.seeds, pagmo_searches().empty() ? "; this program was built without pagmo" : "");
  for (const Subject& subject : subjects) {
    const Runs runs = measure(plan, subject, all);
    const std::string name = "searches_" + subject.posed.body.name();
    page += fmt::format(
                "\n{0}, {1} goals:\n\n![Best score against motions scored, {0}]"
                "(images/experiments/{2}.svg)\n\n",
                subject.posed.body.name(), subject.drawn, name) +
            table_of(subject, all, runs);
    pictures.push_back({name, picture_of(subject, all, runs)});
  }
  return page;
}

}  // namespace shigusa::bench
