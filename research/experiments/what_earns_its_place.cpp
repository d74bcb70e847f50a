// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/run.hpp>

#include "goal_search.hpp"
#include "report.hpp"
#include "search/cma_es.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

constexpr int kBudget = 1000;
constexpr int kStepCounts[] = {20, 60, 200};

// The problem with some coordinates fixed at their start values.
SearchProblem without(const SearchProblem& whole, const std::vector<int>& fixed) {
  SearchProblem part;
  std::vector<std::size_t> kept;
  for (int g = 0; g < whole.genes; ++g) {
    if (std::find(fixed.begin(), fixed.end(), g) == fixed.end()) {
      kept.push_back(static_cast<std::size_t>(g));
    }
  }
  part.genes = static_cast<int>(kept.size());
  for (const std::size_t g : kept) part.start.push_back(whole.start[g]);
  part.evaluate = [whole, kept](std::span<const double> points, std::span<double> scores) {
    std::vector<double> full;
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const std::size_t row = full.size();
      full.insert(full.end(), whole.start.begin(), whole.start.end());
      for (std::size_t k = 0; k < kept.size(); ++k) {
        full[row + kept[k]] = points[i * kept.size() + k];
      }
    }
    whole.evaluate(full, scores);
  };
  return part;
}

struct Variant {
  std::string name;
  std::vector<std::string> left_out;
};

std::vector<Variant> variants(const Subject& subject) {
  GoalSearch searched(subject.posed, subject.places[0].position, {.code = GeneCode::every});
  const std::vector<std::string> names = searched.space().names();
  std::vector<Variant> all{{"the preset's", {"delay", "skew"}},
                           {"with delay", {"skew"}},
                           {"with skew", {"delay"}},
                           {"with delay and skew", {}}};
  std::vector<std::string> postures;
  std::vector<std::string> weights;
  for (const std::string& name : names) {
    const bool weight = name.find('.') != std::string::npos;
    const bool path = name == "bow" || name == "sway";
    const bool timing = name == "delay" || name == "skew";
    if (weight) weights.push_back(name);
    if (!weight && !path && !timing) postures.push_back(name);
  }
  const auto without = [&all](const std::string& what, std::vector<std::string> left_out) {
    left_out.insert(left_out.end(), {"delay", "skew"});
    all.push_back({"without " + what, std::move(left_out)});
  };
  for (const std::string& name : postures) without(name, {name});
  for (const char* name : {"bow", "sway"}) without(name, {name});
  without("bow and sway", {"bow", "sway"});
  without("postures", postures);
  std::vector<std::string> besides = postures;
  besides.insert(besides.end(), {"bow", "sway"});
  without("anything but weights", besides);
  without("any weight", weights);
  return all;
}

double score_of(const Plan& plan, const Subject& subject, const Place& place,
                const Variant& variant) {
  GoalSearch searched(subject.posed, place.position, {.code = GeneCode::every});
  std::vector<int> fixed;
  for (const std::string& name : variant.left_out) fixed.push_back(searched.space().find(name));
  const SearchProblem problem = without(searched.problem(), fixed);
  std::vector<double> scores;
  for (int seed = 1; seed <= plan.few_seeds; ++seed) {
    scores.push_back(
        cma_es_search(problem, {.evaluations = kBudget, .seed = static_cast<std::uint64_t>(seed)})
            .best_seen.score);
  }
  return median(scores);
}

std::string parameters_table(const Plan& plan, const Subject& subject) {
  const std::vector<Variant> all = variants(subject);
  const std::size_t places = subject.places.size();
  std::vector<std::vector<double>> scores(all.size(), std::vector<double>(places));
  parallel_for(static_cast<int>(all.size() * places), 0, [&](int i, int) {
    const std::size_t v = static_cast<std::size_t>(i) / places;
    const std::size_t p = static_cast<std::size_t>(i) % places;
    scores[v][p] = score_of(plan, subject, subject.places[p], all[v]);
  });
  Table table({"parameters", "best score", "beside the preset's", "goals worse by over 2 %",
               "better by over 2 %", "low front-left", "at the feet", "high right"});
  for (std::size_t v = 0; v < all.size(); ++v) {
    std::vector<double> ratios;
    for (std::size_t p = 0; p < places; ++p) ratios.push_back(scores[v][p] / scores[0][p]);
    const std::vector<double> drawn = of_drawn(subject, ratios);
    const auto worse = std::count_if(drawn.begin(), drawn.end(), [](double r) { return r > 1.02; });
    const auto better =
        std::count_if(drawn.begin(), drawn.end(), [](double r) { return r < 1.0 / 1.02; });
    std::vector<std::string> cells{all[v].name, spread(of_drawn(subject, scores[v])), spread(drawn),
                                   std::to_string(worse), std::to_string(better)};
    for (std::size_t p = subject.drawn; p < places; ++p) {
      cells.push_back(fmt::format("{:.3f}", ratios[p]));
    }
    table.add(cells);
  }
  return fmt::format("\n{}:\n\n", subject.posed.body.name()) + table.text();
}

// Score of a search with one number of steps, and the score of its motion played with another.
struct Stepped {
  double own = 0.0;           // the best score, at its own steps
  double fine = 0.0;          // the same parameters at the most steps
  double microseconds = 0.0;  // a motion in the search
};

Stepped step(const Plan& plan, const Subject& subject, const Place& place, int steps) {
  GoalSearch searched(subject.posed, place.position, {.steps = steps});
  GoalSearch finest(subject.posed, place.position,
                    {.steps = kStepCounts[std::size(kStepCounts) - 1]});
  std::vector<double> own, fine, times;
  for (int seed = 1; seed <= plan.slow_seeds; ++seed) {
    const Stopwatch watch;
    const Individual best =
        cma_es_search(searched.problem(),
                      {.evaluations = kBudget, .seed = static_cast<std::uint64_t>(seed)})
            .best_seen;
    times.push_back(1e3 * watch.milliseconds() / kBudget);
    own.push_back(searched.replayed(best.point));
    fine.push_back(finest.replayed(best.point));
  }
  return {median(own), median(fine), median(times)};
}

std::string steps_table(const Plan& plan, std::span<const Subject> subjects) {
  Table table({"body", "steps", "best score", "beside 60", "played with 200 steps", "beside 60",
               "missed with 200 steps", "µs a motion"});
  for (const Subject& subject : subjects) {
    std::vector<std::vector<Stepped>> all;
    for (const int steps : kStepCounts) {
      std::vector<Stepped>& of = all.emplace_back(subject.drawn);
      parallel_for(static_cast<int>(of.size()), 0, [&](int i, int) {
        const auto p = static_cast<std::size_t>(i);
        of[p] = step(plan, subject, subject.places[p], steps);
      });
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      std::vector<double> own, fine, own_ratio, fine_ratio, times;
      int missed = 0;
      for (std::size_t p = 0; p < subject.drawn; ++p) {
        own.push_back(all[k][p].own);
        fine.push_back(all[k][p].fine);
        own_ratio.push_back(all[k][p].own / all[1][p].own);
        fine_ratio.push_back(all[k][p].fine / all[1][p].fine);
        times.push_back(all[k][p].microseconds);
        missed += all[k][p].fine >= worst_score(default_criteria()) ? 1 : 0;
      }
      table.add({subject.posed.body.name(), std::to_string(kStepCounts[k]), spread(own),
                 fmt::format("{:.3f}", median(own_ratio)), spread(fine),
                 fmt::format("{:.3f}", median(fine_ratio)), std::to_string(missed),
                 fmt::format("{:.1f}", median(times))});
    }
  }
  return table.text();
}

}  // namespace

std::string what_earns_its_place(const Plan& plan, std::span<const Subject> subjects) {
  std::string page = fmt::format(
      "CMA-ES over the parameters of the preset flat, {} motions, {} seeds, default criteria. "
      "Leaving a parameter out is fixing it where the start has it: weights alike, no change of "
      "posture, no delay, a straight path. The preset searches neither delay nor skew. Beside the "
      "preset's: the ratio of best scores on each goal; above 1 is worse. With less to search, a "
      "budget reaches further, so a ratio below 1 without a parameter says that it costs more "
      "than it brings at this budget.\n",
      kBudget, plan.few_seeds);
  for (const Subject& subject : subjects) page += parameters_table(plan, subject);
  return page +
         fmt::format(
             "\nSteps of a motion: the search's number ({} seeds), and the parameters "
             "that were found played again with 200, both in double. The last column is "
             "the search's time for each motion on one thread.\n\n",
             plan.slow_seeds) +
         steps_table(plan, subjects);
}

}  // namespace shigusa::bench
