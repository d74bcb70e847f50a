// SPDX-License-Identifier: MIT
#include "searched.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/core/check.hpp>
#include <shigusa/core/parallel.hpp>
#include <string>
#include <utility>

#include "ways.hpp"

namespace shigusa {
namespace {

// Shares of the budget: of all parameters together, and of each style.
constexpr double kFreeShare = 0.6;
constexpr double kStyleShare = 0.2;
// A part is at least a population of the genetic searches; a budget too small for three of them is
// spent on all parameters together, up to that many.
constexpr int kLeastStyleBudget = kPaperPopulation;
constexpr int kLeastFreeBudget = 3 * kPaperPopulation;
constexpr double kStiffKnee = 1.0;  // logarithm of the least weight of a knee that goes by the dial
constexpr std::pair<double, double> kStyleRanges[] = {{0.0, radians(30.0)},
                                                      {radians(115.0), radians(138.0)}};  // rad

void add(SearchResult part, SearchResult& all) {
  all.evaluations += part.evaluations;
  all.rejected_nan += part.rejected_nan;
  all.generations += part.generations;
  all.end = part.end;
  if (part.best_seen.score < all.best_seen.score) all.best_seen = std::move(part.best_seen);
}

// What somebody else's search has found.
void check_point(const Individual& found, int genes) {
  SHG_CHECK(static_cast<int>(found.point.size()) == genes,
            fmt::format("a search returned {} coordinates of {}", found.point.size(), genes));
  for (const double x : found.point) {
    SHG_CHECK(x >= 0.0 && x <= 1.0, fmt::format("a search returned a coordinate of {}", x));
  }
}

}  // namespace

SearchMethod search_of(const Task& task) {
  return task.search.value_or(preset_search(task.preset));
}

// The paper's own searches go over its codes; the others over a wider range.
GeneCode gene_code(const Task& task) {
  if (task.preset != Preset::paper) return GeneCode::natural;
  if (task.own_search) return GeneCode::logarithmic;
  switch (search_of(task)) {
    case SearchMethod::paper_ga:
    case SearchMethod::annealing:
    case SearchMethod::random:
      return GeneCode::paper;
    default:
      return GeneCode::logarithmic;
  }
}

Searched::Searched(const ReachProblem& problem, const Task& task)
    : problem_(problem),
      task_(task),
      criteria_(task_criteria(task)),
      space_(problem, gene_code(task), task.fixed, task.phases),
      batch_(problem, criteria_, task.batch),
      archive_(*problem.body),
      dial_(SquatDial::of(task)) {}

SearchResult Searched::run(const Progress& progress) {
  const int budget = task_.evaluations.value_or(
      task_.generator == MotionGenerator::nlp_ik ? kNlpEvaluations : kFlatEvaluations);
  if (task_.preset == Preset::paper) return run_in({}, budget, progress);
  const int squat = space_.find("squat");
  if (squat < 0) return run_in(stiff_knees(), budget, progress);
  const int free =
      std::max(static_cast<int>(kFreeShare * budget), std::min(budget, kLeastFreeBudget));
  SearchResult all = run_in({}, free, progress);
  const int style = static_cast<int>(kStyleShare * budget);
  if (style < kLeastStyleBudget) return all;
  for (const auto& [low, high] : kStyleRanges) {
    if (all.end == SearchEnd::cancelled) break;
    Niche niche = stiff_knees();
    for (const int gene : {squat, space_.find("later.squat")}) {
      if (gene < 0) continue;
      niche.push_back({gene, space_.coordinate(gene, low), space_.coordinate(gene, high)});
    }
    add(run_in(niche, style, progress), all);
  }
  return all;
}

// Where the knees' flexion is given they go by it: light ones would bend as the hand has it.
Searched::Niche Searched::stiff_knees() const {
  Niche niche;
  for (const char* name : {"knee.flexion", "left_knee.flexion", "right_knee.flexion"}) {
    for (const int gene : {space_.find(name), space_.find(std::string(kLaterPrefix) + name)}) {
      if (gene >= 0) niche.push_back({gene, space_.coordinate(gene, kStiffKnee), 1.0});
    }
  }
  return niche;
}

void Searched::take_in(const Niche& niche, std::span<double> points, std::size_t genes) {
  for (const Bound& bound : niche) {
    for (auto k = static_cast<std::size_t>(bound.gene); k < points.size(); k += genes) {
      points[k] = bound.low + points[k] * (bound.high - bound.low);
    }
  }
}

SearchResult Searched::run_in(const Niche& niche, int budget, const Progress& progress) {
  SearchProblem searched;
  searched.genes = space_.genes();
  searched.start = space_.start();
  for (const Bound& bound : niche) searched.start[static_cast<std::size_t>(bound.gene)] = 0.5;
  const auto genes = static_cast<std::size_t>(searched.genes);
  searched.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    moved_.assign(points.begin(), points.end());
    take_in(niche, moved_, genes);
    evaluate(moved_, scores);
  };
  SearchResult found = search_with(searched, budget, progress);
  take_in(niche, found.best_seen.point, genes);
  for (Individual& individual : found.final_population) {
    take_in(niche, individual.point, genes);
  }
  return found;
}

SearchResult Searched::search_with(const SearchProblem& searched, int budget,
                                   const Progress& progress) {
  if (task_.own_search) {
    SearchResult found = task_.own_search(searched, budget, task_.genetic.seed, progress);
    check_point(found.best_seen, searched.genes);
    for (const Individual& individual : found.final_population) {
      check_point(individual, searched.genes);
    }
    return found;
  }
  const SearchMethod method = search_of(task_);
  if (method != SearchMethod::paper_ga && method != SearchMethod::log_ga) {
    return search(method, searched, budget, task_.genetic.seed, progress);
  }
  const bool once = !task_.evaluations && task_.preset == Preset::paper;
  return once ? genetic_search(searched, task_.genetic, progress)
              : restarted_genetic_search(searched, task_.genetic, budget, progress);
}

void Searched::evaluate(std::span<const double> points, std::span<double> scores) {
  const std::size_t dofs = problem_.body->dofs().size();
  const bool kept = task_.preset != Preset::paper;
  angles_.resize(kept ? scores.size() * dofs : 0);
  // criteria of the user's own want whole motions, and NLP-IK has no lanes
  const bool whole = !criteria_.user.empty() || task_.generator != MotionGenerator::weighted_ik;
  if (whole) {
    score_one_by_one(points, scores);
  } else {
    batch_.score(space_.rows(points), scores, angles_);
  }
  if (!kept) return;
  kept_scores_.assign(scores.begin(), scores.end());
  for (std::size_t i = 0; dial_ && i < scores.size(); ++i) {
    const double off = dial_->off({angles_.data() + i * dofs, dofs});
    if (off > kDialSlack) kept_scores_[i] = worst_score(criteria_);
    scores[i] += kDialPull * max(0.0, off - kDialAim);
  }
  archive_.add(points, kept_scores_, angles_, worst_score(criteria_));
}

void Searched::score_one_by_one(std::span<const double> points, std::span<double> scores) {
  const auto genes = static_cast<std::size_t>(space_.genes());
  const std::size_t dofs = problem_.body->dofs().size();
  const auto score = [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    const RolledOut rolled =
        play(problem_, space_.decode(points.subspan(i * genes, genes)), task_.generator);
    scores[i] = rolled.outcome.met(problem_.tolerance)
                    ? score_motion(*problem_.body, rolled.motion, criteria_).total
                    : worst_score(criteria_);
    if (angles_.empty()) return;
    const Clip& clip = rolled.motion.clip;
    std::transform(clip.frame(clip.frames - 1).begin(), clip.frame(clip.frames - 1).end(),
                   angles_.begin() + static_cast<std::ptrdiff_t>(i * dofs),
                   [](double angle) { return static_cast<float>(angle); });
  };
  // a user's functions are called from one thread only
  const int threads = criteria_.user.empty() ? task_.batch.threads : 1;
  parallel_for(static_cast<int>(scores.size()), threads, score);
}

}  // namespace shigusa
