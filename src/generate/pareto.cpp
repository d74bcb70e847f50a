// SPDX-License-Identifier: MIT
#include "pareto.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "candidate.hpp"
#include "core/say.hpp"
#include "distinct.hpp"
#include "joint_progress.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kPairedAxes = 3;  // with more criteria, pairs are too many searches

// The settings with equal weights for the given criteria (indices in kCriteria) and none for the
// others.
CriteriaSettings weighted(const CriteriaSettings& criteria, std::span<const std::size_t> axes) {
  CriteriaSettings settings = criteria;
  settings.user.clear();
  for (CriterionSetting& setting : settings.built_in) setting.weight = 0.0;
  for (const std::size_t axis : axes) {
    settings.built_in[axis].weight = 1.0 / static_cast<double>(axes.size());
  }
  return settings;
}

bool dominates(const Score& a, const Score& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.terms.size(); ++k) {
    if (!(a.terms[k].penalty <= b.terms[k].penalty)) return false;
    better = better || a.terms[k].penalty < b.terms[k].penalty;
  }
  return better;
}

// The best of each group of candidates with similar ends.
std::vector<Candidate> without_copies(std::vector<Candidate> front) {
  std::stable_sort(front.begin(), front.end(), RanksBefore{});
  std::vector<Candidate> apart;
  for (Candidate& candidate : front) {
    const auto is_copy = [&](const Candidate& better) {
      return final_distance(better.motion.clip, candidate.motion.clip) < kDistinctEnd;
    };
    if (std::none_of(apart.begin(), apart.end(), is_copy)) apart.push_back(std::move(candidate));
  }
  return apart;
}

// Penalties divided by their range in the front, 0 for the best.
std::vector<std::vector<double>> scaled_penalties(std::span<const Candidate> front) {
  std::vector<std::vector<double>> scaled(front.size());
  for (std::size_t k = 0; k < front.front().score.terms.size(); ++k) {
    const auto of = [&](const Candidate& c) { return c.score.terms[k].penalty; };
    const auto [low, high] =
        std::minmax_element(front.begin(), front.end(),
                            [&](const Candidate& a, const Candidate& b) { return of(a) < of(b); });
    const double range = of(*high) - of(*low);
    for (std::size_t i = 0; i < front.size(); ++i) {
      scaled[i].push_back(range > 0.0 ? (of(front[i]) - of(*low)) / range : 0.0);
    }
  }
  return scaled;
}

double square_distance(std::span<const double> a, std::span<const double> b) {
  double squares = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return squares;
}

// The best candidate by each criterion, without repetition; ties are broken by the sum of
// penalties.
std::vector<std::size_t> best_by_each(std::span<const std::vector<double>> scaled) {
  const auto sum = [](const std::vector<double>& penalties) {
    return std::accumulate(penalties.begin(), penalties.end(), 0.0);
  };
  std::vector<std::size_t> taken;
  for (std::size_t k = 0; k < scaled.front().size(); ++k) {
    const auto best =
        std::min_element(scaled.begin(), scaled.end(), [&](const auto& a, const auto& b) {
          return a[k] < b[k] || (a[k] == b[k] && sum(a) < sum(b));
        });
    const auto i = static_cast<std::size_t>(best - scaled.begin());
    if (std::find(taken.begin(), taken.end(), i) == taken.end()) taken.push_back(i);
  }
  return taken;
}

// The candidate farthest from all those taken.
std::size_t farthest_from(std::span<const std::size_t> taken,
                          std::span<const std::vector<double>> scaled) {
  double farthest = -1.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t t : taken) {
      nearest = min(nearest, t == i ? -1.0 : square_distance(scaled[i], scaled[t]));
    }
    if (nearest > farthest) {
      farthest = nearest;
      next = i;
    }
  }
  return next;
}

}  // namespace

std::vector<CriteriaSettings> pareto_mixtures(const CriteriaSettings& criteria) {
  std::vector<std::size_t> axes;
  for (std::size_t k = 0; k < criteria.built_in.size(); ++k) {
    if (criteria.built_in[k].weight > 0.0) axes.push_back(k);
  }
  std::vector<CriteriaSettings> mixtures{criteria};
  if (axes.size() < 2) return mixtures;
  for (const std::size_t axis : axes) mixtures.push_back(weighted(criteria, {&axis, 1}));
  for (std::size_t i = 0; axes.size() <= kPairedAxes && i < axes.size(); ++i) {
    for (std::size_t k = i + 1; k < axes.size(); ++k) {
      const std::size_t pair[] = {axes[i], axes[k]};
      mixtures.push_back(weighted(criteria, pair));
    }
  }
  return mixtures;
}

std::vector<Candidate> not_dominated(std::vector<Candidate> candidates) {
  std::vector<char> worse(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    worse[i] = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
      return dominates(other.score, candidates[i].score);
    });
  }
  std::vector<Candidate> front;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (worse[i] == 0) front.push_back(std::move(candidates[i]));
  }
  return front;
}

std::vector<Candidate> spread_over(std::vector<Candidate> front, int most) {
  if (front.empty()) return front;
  const std::vector<std::vector<double>> scaled = scaled_penalties(front);
  const std::size_t count = std::min(front.size(), static_cast<std::size_t>(most));
  std::vector<std::size_t> taken = best_by_each(scaled);
  while (taken.size() < count) taken.push_back(farthest_from(taken, scaled));
  taken.resize(count);
  std::vector<Candidate> chosen;
  for (const std::size_t i : taken) chosen.push_back(std::move(front[i]));
  std::stable_sort(chosen.begin(), chosen.end(), RanksBefore{});
  return chosen;
}

void search_front(const Task& task, const RunSettings& run, Planner& planner, std::size_t approach,
                  const Progress& progress, GenerateResult& generation) {
  const std::vector<CriteriaSettings> mixtures = pareto_mixtures(run.criteria);
  const int share = run.evaluations.value_or(kFlatEvaluations) / static_cast<int>(mixtures.size());
  std::vector<Candidate> all;
  JointProgress joint(progress);
  RunSettings part = run;
  part.evaluations = std::max(share, kPaperPopulation);
  for (const CriteriaSettings& mixture : mixtures) {
    part.criteria = mixture;
    const Found found =
        planner.search(part, approach, joint.part(1.0 / static_cast<double>(mixtures.size())));
    add_counts(found.result, generation);
    for (const Individual& individual : found.selection.picked) {
      const Expanded expanded = planner.expand(individual.point);
      if (auto arrival = planner.arrival(expanded.values, approach)) {
        all.push_back(planner.candidate(expanded, std::move(*arrival)));
      } else {
        ++generation.log.missed;
      }
    }
    if (found.result.end == SearchEnd::cancelled) break;
  }
  const std::size_t kept = all.size();
  std::vector<Candidate> front = not_dominated(std::move(all));
  const std::size_t with_copies = front.size();
  front = without_copies(std::move(front));
  generation.log.near_copies += static_cast<int>(with_copies - front.size());
  const std::size_t size = front.size();
  generation.candidates = spread_over(std::move(front), task.candidates);
  if (static_cast<int>(size) >= task.candidates) return;
  generation.fewer = say("fewer_pareto", size, task.candidates, kept);
}

}  // namespace shigusa
