// SPDX-License-Identifier: MIT
#include "searched.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/core/check.hpp>
#include <shigusa/core/parallel.hpp>
#include <shigusa/search/cma_es.hpp>
#include <string>
#include <utility>

#include "ways.hpp"

namespace shigusa {
namespace {

// Share of the budget of all parameters together, beside styles.
constexpr double kFreeShare = 0.4;
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
  if (task_.preset == Preset::paper) return run_in({}, {}, budget, progress);
  // where a person gives the squat, knees go by it
  const Niche all_knees = space_.find("squat") < 0 ? stiff_knees() : Niche{};
  if (static_cast<int>(kStyleShare * budget) < kLeastStyleBudget) {
    return run_in(all_knees, {}, budget, progress);
  }
  SearchResult all = run_in(all_knees, {}, static_cast<int>(kFreeShare * budget), progress);
  double left = 1.0 - kFreeShare;
  for (const Style& style : styles()) {
    if (all.end == SearchEnd::cancelled) return all;
    if (style.share > left + 1e-6) break;
    const std::vector<double> from = style.far ? std::vector<double>{} : guess_.point;
    add(run_in(style.niche, from, static_cast<int>(style.share * budget), progress), all);
    left -= style.share;
  }
  // of the styles that the task has not
  const int rest = static_cast<int>(left * budget + 1e-6);
  if (rest > 0 && all.end != SearchEnd::cancelled) {
    add(run_in(all_knees, guess_.point, rest, progress), all);
  }
  return all;
}

void Searched::take_in(const Niche& niche, std::span<double> points, std::size_t genes) {
  for (const Bound& bound : niche) {
    for (auto k = static_cast<std::size_t>(bound.gene); k < points.size(); k += genes) {
      points[k] = bound.low + points[k] * (bound.high - bound.low);
    }
  }
}

SearchResult Searched::run_in(const Niche& niche, const std::vector<double>& from, int budget,
                              const Progress& progress) {
  SearchProblem searched;
  searched.genes = space_.genes();
  searched.start = from.empty() ? space_.start() : from;
  for (const Bound& bound : niche) {
    double& x = searched.start[static_cast<std::size_t>(bound.gene)];
    const bool within = !from.empty() && x > bound.low && x < bound.high;
    x = within ? (x - bound.low) / (bound.high - bound.low) : 0.5;
  }
  const auto genes = static_cast<std::size_t>(searched.genes);
  searched.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    moved_.assign(points.begin(), points.end());
    take_in(niche, moved_, genes);
    evaluate(moved_, scores);
  };
  SearchResult found;
  // in a niche it is not the knees that are chosen
  if (task_.preset != Preset::paper && niche.empty() && from.empty())
    found = begin_bent(searched, budget);
  if (budget > found.evaluations) {
    SearchResult rest = search_with(searched, budget - found.evaluations, progress);
    found.final_population = std::move(rest.final_population);
    add(std::move(rest), found);
  }
  take_in(niche, found.best_seen.point, genes);
  for (Individual& individual : found.final_population) {
    take_in(niche, individual.point, genes);
  }
  return found;
}

// Where all parameters together may begin, (points × genes): each lean of the trunk with each bend
// of the knees.
std::vector<double> Searched::postures() const {
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
SearchResult Searched::begin_bent(SearchProblem& searched, int budget) const {
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
  if (method == SearchMethod::cma_es && task_.preset != Preset::paper) {
    return cma_es_search(
        searched, {.evaluations = budget, .step = kStep, .seed = task_.genetic.seed}, progress);
  }
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
  guess(points, kept_scores_);
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
