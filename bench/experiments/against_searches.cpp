// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/core/parallel.hpp>
#include <shigusa/search/searches.hpp>

#include "goal_search.hpp"
#include "pagmo_runs.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

const std::vector<int> kBudgets{100, 300, 1000, 3000};

// One way to search: ours on a code, or one of pagmo's.
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

// (budgets) the median over the seeds, of one place
std::vector<double> best_of(const Searcher& searcher, const Plan& plan, const BodyModel& body,
                            const Vec3d& goal) {
  GoalSearch searched(body, goal, default_criteria(), searcher.code);
  const SearchProblem problem = searched.problem();
  std::vector<std::vector<double>> of_seeds;
  if (searcher.ours) {
    for (int seed = 1; seed <= plan.few_seeds; ++seed) {
      BestAt best(kBudgets);
      (void)search(*searcher.ours, best.watch(problem), kBudgets.back(),
                   static_cast<std::uint64_t>(seed));
      of_seeds.push_back(best.best());
    }
  } else {
    of_seeds = run_pagmo(searcher.name, problem, plan.few_seeds, kBudgets);
  }
  std::vector<double> medians;
  for (std::size_t b = 0; b < kBudgets.size(); ++b) {
    std::vector<double> scores;
    for (const std::vector<double>& one : of_seeds) scores.push_back(one[b]);
    medians.push_back(median(scores));
  }
  return medians;
}

// [searcher][budget](places)
using Scores = std::vector<std::vector<std::vector<double>>>;

Scores measure(const Plan& plan, const Subject& subject, const std::vector<Searcher>& all) {
  const std::size_t places = subject.places.size();
  Scores scores(all.size(), std::vector(kBudgets.size(), std::vector<double>(places)));
  parallel_for(static_cast<int>(all.size() * places), 0, [&](int i, int) {
    const std::size_t s = static_cast<std::size_t>(i) / places;
    const std::size_t p = static_cast<std::size_t>(i) % places;
    const std::vector<double> best =
        best_of(all[s], plan, subject.body, subject.places[p].position);
    for (std::size_t b = 0; b < kBudgets.size(); ++b) scores[s][b][p] = best[b];
  });
  return scores;
}

std::string table_of(const Subject& subject, const std::vector<Searcher>& all,
                     const Scores& scores) {
  std::vector<std::string> head{"search"};
  for (const int budget : kBudgets) head.push_back(std::to_string(budget));
  for (const int budget : kBudgets) head.push_back("beside cma_es, " + std::to_string(budget));
  Table table(head);
  for (std::size_t s = 0; s < all.size(); ++s) {
    std::vector<std::string> cells{(all[s].ours ? "" : "pagmo ") + all[s].name};
    for (std::size_t b = 0; b < kBudgets.size(); ++b) {
      cells.push_back(spread(of_drawn(subject, scores[s][b])));
    }
    for (std::size_t b = 0; b < kBudgets.size(); ++b) {
      std::vector<double> ratios;
      for (std::size_t p = 0; p < subject.drawn; ++p) {
        ratios.push_back(scores[s][b][p] / scores[0][b][p]);
      }
      cells.push_back(fmt::format("{:.3f}", median(ratios)));
    }
    table.add(cells);
  }
  return table.text();
}

}  // namespace

std::string against_searches(const Plan& plan, std::span<const Subject> subjects) {
  const std::vector<Searcher> all = searchers();
  std::string page = fmt::format(
      "Every search minimises the same SearchProblem from one start: the parameters of the preset "
      "flat, the default criteria, limits kept, one hand path; `paper_ga` alone has another space, "
      "the paper's weights, on the same motions and scores. Best score after so many "
      "motions, {} seeds{}. Beside cma_es: the median over the goals of the ratio to the default's "
      "score on that goal; above 1 is worse. pagmo's have their own defaults, a population of 20 "
      "with the start among it, the cube's faces enforced, and start again when they converge; "
      "they score one point at a time, so time is not compared.\n",
      plan.few_seeds, pagmo_searches().empty() ? "; this program was built without pagmo" : "");
  for (const Subject& subject : subjects) {
    const Scores scores = measure(plan, subject, all);
    page += fmt::format("\n{}, {} goals:\n\n", subject.body.name(), subject.drawn) +
            table_of(subject, all, scores);
  }
  return page;
}

}  // namespace shigusa::bench
