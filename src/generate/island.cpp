// SPDX-License-Identifier: MIT
#include "island.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {
namespace {

// Checks a point returned by a user's own search.
void check_point(const Individual& found, int genes) {
  SHG_CHECK(static_cast<int>(found.point.size()) == genes,
            fmt::format("a search returned {} coordinates of {}", found.point.size(), genes));
  for (const double x : found.point) {
    SHG_CHECK(x >= 0.0 && x <= 1.0, fmt::format("a search returned a coordinate of {}", x));
  }
}

}  // namespace

void add(SearchResult part, SearchResult& all) {
  all.evaluations += part.evaluations;
  all.rejected_nan += part.rejected_nan;
  all.generations += part.generations;
  if (all.end != SearchEnd::cancelled) all.end = part.end;
  const bool better = part.best_seen.score < all.best_seen.score;
  if (better || all.best_seen.point.empty()) all.best_seen = std::move(part.best_seen);
}

Island::Island(const Problem& problem, const ReachProblem& approach, const RunSettings& run,
               const ParameterSpace& space, const KnownStarts& known, IslandPlan plan, int threads,
               const Progress& progress)
    : task_(problem.task),
      approach_(approach),
      run_(run),
      space_(space),
      known_(known),
      plan_(std::move(plan)),
      scorer_(problem, approach, run.criteria, space_, threads),
      progress_(progress) {
  searched_.genes = space_.genes();
  searched_.evaluate = [this](std::span<const double> points, std::span<double> scores) {
    moved_.assign(points.begin(), points.end());
    take_in(moved_);
    scorer_.score(moved_, scores);
  };
  searched_.start = plan_.from.empty() ? space_.start() : plan_.from;
  for (const Bound& bound : plan_.niche) {
    double& x = searched_.start[index(bound.gene)];
    const bool within = !plan_.from.empty() && x > bound.low && x < bound.high;
    x = within ? (x - bound.low) / (bound.high - bound.low) : 0.5;
  }
  if (!progress.report) return;
  progress_.report = [this, report = progress.report](ProgressReport now) {
    now.evaluations += found_.evaluations;
    report(now);
  };
}

void Island::run_to(int motions) {
  if (!begun_) begin();
  if (cma_es_) cma_es_->run_to(motions - found_.evaluations);
}

SearchResult Island::take_result() {
  if (cma_es_) {
    SearchResult rest = cma_es_->take_result();
    found_.final_population = std::move(rest.final_population);
    add(std::move(rest), found_);
  }
  take_in(found_.best_seen.point);
  for (Individual& individual : found_.final_population) take_in(individual.point);
  return std::move(found_);
}

void Island::begin() {
  begun_ = true;
  if (plan_.bent || plan_.style) begin_at_best();
  const int left = plan_.budget - found_.evaluations;
  if (left <= 0) return;
  if (search_of(task_) == SearchMethod::cma_es && task_.preset != Preset::paper &&
      !task_.own_search) {
    // Mirrored sampling and scales alone converge faster; style islands look for other motions than
    // the best.
    const bool everywhere = plan_.niche.empty();
    cma_es_.emplace(searched_,
                    CmaEsSettings{.evaluations = left,
                                  .step = plan_.step,
                                  .scales = scales_,
                                  .mirrored = everywhere,
                                  .diagonal_until = everywhere ? kScalesAlone * searched_.genes : 0,
                                  .seed = run_.seed,
                                  .stream = plan_.stream},
                    progress_);
    return;
  }
  SearchResult rest = search_at_once(left);
  found_.final_population = std::move(rest.final_population);
  add(std::move(rest), found_);
}

// Scores the start point, known starts for nearby goals and bent postures, and begins at the best:
// a search that begins upright finds bent postures only by chance.
void Island::begin_at_best() {
  std::vector<double> points =
      plan_.style ? known_.within(plan_.niche) : known_.points(task_.starts);
  if (!plan_.style) scales_ = start_scales(points, space_.genes());
  // a part gives the knees itself
  const std::vector<double> others =
      plan_.niche.empty() ? habit_starts(approach_, space_, points) : std::vector<double>{};
  points.insert(points.begin(), plan_.from.begin(), plan_.from.end());
  if (plan_.bent) {
    const std::vector<double> bent = bent_starts(space_);
    points.insert(points.end(), bent.begin(), bent.end());
  }
  points.insert(points.end(), others.begin(), others.end());
  if (points.size() <= plan_.from.size()) return;
  bring_in(points);
  const auto genes = index(searched_.genes);
  // the search that follows needs a population
  const int most = plan_.style ? plan_.budget / 2 : plan_.budget;
  const auto count = std::min(index(most), points.size() / genes);
  points.resize(count * genes);
  std::vector<double> scores(count);
  searched_.evaluate(points, scores);
  found_.evaluations = static_cast<int>(count);
  for (double& score : scores) {
    if (score == score) continue;
    ++found_.rejected_nan;
    score = worst_score(run_.criteria);
  }
  const auto best = std::min_element(scores.begin(), scores.end());
  const auto at = points.begin() + (best - scores.begin()) * searched_.genes;
  searched_.start.assign(at, at + searched_.genes);
  found_.best_seen = {searched_.start, *best};
}

SearchResult Island::search_at_once(int budget) const {
  if (!task_.own_search) {
    const bool once = !run_.evaluations && task_.preset == Preset::paper;
    return run_search(task_, run_, searched_, budget, once, progress_);
  }
  SearchResult found = task_.own_search(searched_, budget, run_.seed, progress_);
  check_point(found.best_seen, searched_.genes);
  for (const Individual& individual : found.final_population) {
    check_point(individual, searched_.genes);
  }
  return found;
}

void Island::take_in(std::span<double> points) const {
  const auto genes = index(searched_.genes);
  for (const Bound& bound : plan_.niche) {
    for (auto k = index(bound.gene); k < points.size(); k += genes) {
      points[k] = bound.low + points[k] * (bound.high - bound.low);
    }
  }
}

void Island::bring_in(std::span<double> points) const {
  const auto genes = index(searched_.genes);
  for (const Bound& bound : plan_.niche) {
    for (auto k = index(bound.gene); k < points.size(); k += genes) {
      points[k] = clamp((points[k] - bound.low) / (bound.high - bound.low), 0.0, 1.0);
    }
  }
}

}  // namespace shigusa
