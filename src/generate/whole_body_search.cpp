// SPDX-License-Identifier: MIT
#include "whole_body_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <shigusa/parallel.hpp>
#include <string>
#include <utility>

#include "core/check.hpp"
#include "joint_progress.hpp"
#include "search/cma_es.hpp"
#include "task/task_search.hpp"

namespace shigusa {
namespace {

// A style's part is at least a population of the genetic searches; a budget too small for that is
// spent on all parameters together.
constexpr int kLeastStyleBudget = kPaperPopulation;
// Standard deviation that a run begins with: posture modes say which way is down, so that motions
// near the start are worth more than motions anywhere.
constexpr double kStep = 0.15;

// Where a search may begin (deg): leans of the trunk, half of it in the back, and bends of the
// knees.
constexpr double kLeans[] = {0.0, 30.0, 60.0, 90.0};
constexpr double kSquats[] = {0.0, 40.0, 80.0, 120.0};

void add(SearchResult part, SearchResult& all) {
  all.evaluations += part.evaluations;
  all.rejected_nan += part.rejected_nan;
  all.generations += part.generations;
  all.end = part.end;
  const bool better = part.best_seen.score < all.best_seen.score;
  if (better || all.best_seen.point.empty()) all.best_seen = std::move(part.best_seen);
}

// Checks a point that a user's own search has found.
void check_point(const Individual& found, int genes) {
  SHG_CHECK(static_cast<int>(found.point.size()) == genes,
            fmt::format("a search returned {} coordinates of {}", found.point.size(), genes));
  for (const double x : found.point) {
    SHG_CHECK(x >= 0.0 && x <= 1.0, fmt::format("a search returned a coordinate of {}", x));
  }
}

}  // namespace

// The paper's own searches go over its codes; the others over a wider range.
GeneCode gene_code(const Task& task) {
  if (task.preset != Preset::paper) return GeneCode::natural;
  if (task.own_search) return GeneCode::logarithmic;
  return info_of(search_of(task)).paper_code ? GeneCode::paper : GeneCode::logarithmic;
}

WholeBodySearch::WholeBodySearch(const ReachProblem& problem, const Task& task)
    : problem_(problem),
      task_(task),
      criteria_(task_criteria(task)),
      space_(problem, gene_code(task), task.fixed, task.phases),
      archive_(*problem.body) {}

SearchResult WholeBodySearch::run(const Progress& progress) {
  const int budget = task_.evaluations.value_or(usual_evaluations(task_));
  PointScorer scorer(problem_, task_, criteria_, space_, task_.batch.threads);
  const bool paper = task_.preset == Preset::paper;
  // where a person gives the squat, knees go by it
  const Niche all_knees = !paper && space_.find("squat") < 0 ? stiff_knees() : Niche{};
  const bool styled = !paper && static_cast<int>(kStyleShare * budget) >= kLeastStyleBudget;
  const Part all{all_knees, {}, styled ? static_cast<int>(kFreeShare * budget) : budget};
  JointProgress joint(progress);
  const auto share = [&](const Part& part) { return static_cast<double>(part.budget) / budget; };
  SearchResult found = run_part(all, scorer, joint.part(share(all)));
  archive_.add(scorer.archive());
  if (styled && found.end != SearchEnd::cancelled) {
    const std::vector<Part> parts = styles(scorer.guess(), budget);
    std::vector<Progress> watched;
    for (const Part& part : parts) watched.push_back(joint.part(share(part)));
    run_parts(parts, watched, found);
  }
  return found;
}

// Parts know nothing of each other, so that they run side by side.
void WholeBodySearch::run_parts(const std::vector<Part>& parts,
                                const std::vector<Progress>& watched, SearchResult& all) {
  // other people's functions are called from one thread, and whole motions take all of them
  const bool together = !task_.own_search && !scores_whole_motions(task_, criteria_);
  const int threads = task_.batch.threads;
  std::deque<PointScorer> scorers;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    scorers.emplace_back(problem_, task_, criteria_, space_, together ? 1 : threads);
  }
  std::vector<SearchResult> found(parts.size());
  const auto run = [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    found[i] = run_part(parts[i], scorers[i], watched[i]);
  };
  parallel_for(static_cast<int>(parts.size()), together ? threads : 1, run);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    add(std::move(found[i]), all);
    archive_.add(scorers[i].archive());
  }
}

void WholeBodySearch::take_in(const Niche& niche, std::span<double> points, std::size_t genes) {
  for (const Bound& bound : niche) {
    for (auto k = static_cast<std::size_t>(bound.gene); k < points.size(); k += genes) {
      points[k] = bound.low + points[k] * (bound.high - bound.low);
    }
  }
}

SearchResult WholeBodySearch::run_part(const Part& part, PointScorer& scorer,
                                       const Progress& progress) const {
  SearchProblem searched;
  searched.genes = space_.genes();
  searched.start = part.from.empty() ? space_.start() : part.from;
  for (const Bound& bound : part.niche) {
    double& x = searched.start[static_cast<std::size_t>(bound.gene)];
    const bool within = !part.from.empty() && x > bound.low && x < bound.high;
    x = within ? (x - bound.low) / (bound.high - bound.low) : 0.5;
  }
  const auto genes = static_cast<std::size_t>(searched.genes);
  std::vector<double> moved;
  searched.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    moved.assign(points.begin(), points.end());
    take_in(part.niche, moved, genes);
    scorer.score(moved, scores);
  };
  SearchResult found;
  // a niche says nothing of the knees
  if (task_.preset != Preset::paper && part.niche.empty() && part.from.empty())
    found = begin_bent(searched, part.budget);
  if (part.budget > found.evaluations) {
    Progress own = progress;
    if (progress.report) {
      own.report = [&](ProgressReport report) {
        report.evaluations += found.evaluations;
        progress.report(report);
      };
    }
    SearchResult rest = search_with(searched, part.budget - found.evaluations, own);
    found.final_population = std::move(rest.final_population);
    add(std::move(rest), found);
  }
  take_in(part.niche, found.best_seen.point, genes);
  for (Individual& individual : found.final_population) {
    take_in(part.niche, individual.point, genes);
  }
  return found;
}

// The points (points × genes) where a search of all parameters may begin: each lean of the trunk
// with each bend of the knees.
std::vector<double> WholeBodySearch::postures() const {
  std::vector<double> points;
  const auto set = [&](std::string_view mode, double value) {
    const int gene = space_.find(mode);
    if (gene < 0) return;
    *(points.end() - space_.genes() + gene) = space_.coordinate(gene, radians(value));
  };
  const std::vector<double> upright = space_.start();
  for (const double squat : kSquats) {
    for (const double lean : kLeans) {
      points.insert(points.end(), upright.begin(), upright.end());
      set("squat", squat);
      set("lean", lean);
      set("round", 0.5 * lean);
    }
  }
  return points;
}

// Scores the postures and begins at the best of them: a search that begins upright finds its way
// down by chance.
SearchResult WholeBodySearch::begin_bent(SearchProblem& searched, int budget) const {
  std::vector<double> points = postures();
  const auto genes = static_cast<std::size_t>(searched.genes);
  const auto count = std::min(static_cast<std::size_t>(budget), points.size() / genes);
  points.resize(count * genes);
  std::vector<double> scores(count);
  searched.evaluate(points, scores);
  SearchResult found;
  found.evaluations = static_cast<int>(count);
  for (double& score : scores) {
    if (score == score) continue;
    ++found.rejected_nan;
    score = worst_score(criteria_);
  }
  const auto best = std::min_element(scores.begin(), scores.end());
  const auto at = points.begin() + (best - scores.begin()) * searched.genes;
  searched.start.assign(at, at + searched.genes);
  found.best_seen = {searched.start, *best};
  return found;
}

SearchResult WholeBodySearch::search_with(const SearchProblem& searched, int budget,
                                          const Progress& progress) const {
  if (task_.own_search) {
    SearchResult found = task_.own_search(searched, budget, task_.seed, progress);
    check_point(found.best_seen, searched.genes);
    for (const Individual& individual : found.final_population) {
      check_point(individual, searched.genes);
    }
    return found;
  }
  if (search_of(task_) == SearchMethod::cma_es && task_.preset != Preset::paper) {
    return cma_es_search(searched, {.evaluations = budget, .step = kStep, .seed = task_.seed},
                         progress);
  }
  const bool once = !task_.evaluations && task_.preset == Preset::paper;
  return run_search(task_, searched, budget, once, progress);
}

}  // namespace shigusa
