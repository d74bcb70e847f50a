// SPDX-License-Identifier: MIT
#include "layered_generator.hpp"

#include <algorithm>
#include <limits>
#include <shigusa/core/parallel.hpp>
#include <shigusa/generate/layered_problem.hpp>
#include <utility>

#include "arm_libraries.hpp"
#include "candidate.hpp"
#include "choice.hpp"
#include "layered_search.hpp"
#include "layered_ways.hpp"
#include "task/task_search.hpp"

namespace shigusa {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool searches_paper_code(const Task& task) { return info_of(search_of(task)).paper_code; }

Candidate make_layered(const Task& task, const Parameters& parameters, LayeredArrival arrival) {
  Candidate candidate = make_candidate(task, arrival.way, parameters, std::move(arrival.rolled));
  ArmCollision collision{.depth = -std::numeric_limits<double>::infinity()};
  for (const ReachGoal& goal : arrival.way.goals) {
    const Effector& hand = task.body.effectors()[index(goal.effector)];
    const double depth = collision_depth(task.body, candidate.motion.clip, hand);
    collision.depth = max(collision.depth, depth);
  }
  collision.left = collision.depth > kCollisionDepth;
  candidate.arm_collision = collision;
  return candidate;
}

// The search of the upper layer on one way to the goals: of the whole body its weights alone.
class UpperSearch {
 public:
  UpperSearch(const Task& task, const LayeredProblem& problem, const LayeredWays& ways,
              LayeredWay way, ArmLibraries& libraries)
      : task_(task),
        problem_(problem),
        ways_(ways),
        layers_(way == LayeredWay::layers),
        genes_(searched_genes(problem)),
        archive_(task.body),
        scorer_(problem, problem.layers[0].criteria, task.batch.threads,
                [&libraries](std::span<const HandPath> paths) { return libraries.choose(paths); }) {
    if (layers_) return;
    std::erase_if(genes_, [&problem](std::size_t gene) {
      return problem.layers[0].parameters[gene].kind == ParameterKind::contraction;
    });
  }

  SearchResult run(const Progress& progress) {
    SearchProblem searched;
    searched.genes = static_cast<int>(genes_.size());
    searched.evaluate = [this](std::span<const double> points, std::span<double> scores) {
      std::vector<Parameters> parameters;
      for (std::size_t i = 0; i < scores.size(); ++i) {
        parameters.push_back(decoded(points.subspan(i * genes_.size(), genes_.size())));
      }
      const std::size_t dofs = keeps_ends() ? task_.body.dofs().size() : 0;
      postures_.resize(scores.size() * dofs);
      if (layers_) {
        scorer_.score(parameters, scores, postures_);
      } else {
        score_bodies(parameters, scores);
      }
      if (!keeps_ends()) return;
      archive_.add(points, scores, postures_, worst_score(problem_.layers[0].criteria));
    };
    const int evaluations = task_.evaluations.value_or(usual_evaluations(task_));
    return run_search(task_, searched, evaluations, !task_.evaluations, progress);
  }

  // What is worth expanding of all that was found, best first.
  [[nodiscard]] Choice choice(const SearchResult& found) const {
    return keeps_ends() ? distinct_postures(archive_, 2 * task_.candidates)
                        : Choice{.picked = ranked_population(found)};
  }

  // What a point's motion is generated from, with all that the layers below find for it; or as the
  // search had it.
  LayeredScorer::Played expanded(std::span<const double> point) {
    if (!layers_) return {whole(decoded(point)), 0};
    return scorer_.play(decoded(point), {.rounds = task_.layers.feedback_rounds,
                                         .search = task_.layers.limb_search,
                                         .seed = task_.seed});
  }
  Parameters as_searched(std::span<const double> point) {
    if (!layers_) return whole(decoded(point));
    return scorer_.play(decoded(point), {.rounds = 0, .glance = true}).parameters;
  }

 private:
  [[nodiscard]] bool keeps_ends() const { return traits_of(task_.preset).natural; }
  [[nodiscard]] Parameters decoded(std::span<const double> point) const {
    return decode_searched(problem_, genes_, point, searches_paper_code(task_));
  }

  // with what the layers below have before any search
  [[nodiscard]] Parameters whole(const Parameters& upper) const {
    return below_upper(start_values(problem_.layers), upper);
  }

  void score_bodies(std::span<const Parameters> parameters, std::span<double> scores) {
    const CriteriaSettings& criteria = problem_.layers[0].criteria;
    const std::size_t dofs = postures_.size() / scores.size();
    const auto score = [&](int i, int) {
      const auto k = index(i);
      const auto arrival = ways_.body_arrival(whole(parameters[k]));
      scores[k] = worst_score(criteria);
      if (!arrival) return;
      const Clip& clip = arrival->rolled.motion.clip;
      scores[k] = score_motion(task_.body, arrival->rolled.motion, criteria).total;
      const std::span<const double> last = clip.frame(clip.frames - 1);
      for (std::size_t d = 0; d < dofs; ++d) postures_[k * dofs + d] = static_cast<float>(last[d]);
    };
    // a user's criteria are called by one thread
    parallel_for(static_cast<int>(scores.size()), criteria.user.empty() ? task_.batch.threads : 1,
                 score);
  }

  const Task& task_;
  const LayeredProblem& problem_;
  const LayeredWays& ways_;
  bool layers_;
  std::vector<std::size_t> genes_;
  Archive archive_;
  std::vector<float> postures_;
  LayeredScorer scorer_;
};

// Keeps what arrives on the way that was searched, or before, and differs.
class LayeredDelivery {
 public:
  LayeredDelivery(const Task& task, const LayeredWays& ways, LayeredWay searched,
                  UpperSearch& search, Generation& generation)
      : task_(task), ways_(ways), searched_(searched), search_(search), generation_(generation) {}

  // How many of what is spare became candidates.
  int collect(const Choice& choice) {
    std::vector<Candidate> nearer;  // than kDistinctEnd to a better one
    for (const Individual& individual : choice.picked) {
      if (is_enough()) return 0;
      take(individual.point, tells_ends() ? kDistinctEnd : kDistinctPosture, &nearer);
    }
    if (!tells_ends()) return 0;
    for (Candidate& candidate : nearer) {
      if (is_enough()) return 0;
      if (!is_copy(candidate.motion.clip, kNearEnd)) all().push_back(std::move(candidate));
    }
    const std::size_t before = all().size();
    int tries = 0;
    for (const Archived& spare : choice.spare) {
      if (is_enough() || tries >= task_.candidates) break;
      if (spare.score > choice.picked.front().score + kCandidateSpread) break;
      const auto is_like = [&](const Candidate& c) { return ends_like(c, spare, kNearEnd); };
      if (std::any_of(all().begin(), all().end(), is_like)) continue;
      ++tries;
      take(spare.point, kNearEnd, nullptr);
    }
    return static_cast<int>(all().size() - before);
  }

 private:
  [[nodiscard]] std::vector<Candidate>& all() { return generation_.candidates; }
  [[nodiscard]] bool tells_ends() const { return traits_of(task_.preset).natural; }
  [[nodiscard]] bool is_enough() const {
    return static_cast<int>(generation_.candidates.size()) >= task_.candidates;
  }

  bool is_copy(const Clip& clip, double apart) {
    return std::any_of(all().begin(), all().end(), [&](const Candidate& better) {
      return (tells_ends() ? final_distance(better.motion.clip, clip)
                           : largest_distance(better.motion.clip, clip)) < apart;
    });
  }

  // With all that the layers below find for a point. What is a copy goes to `copies`, if any.
  void take(std::span<const double> point, double apart, std::vector<Candidate>* copies) {
    const LayeredScorer::Played played = search_.expanded(point);
    std::optional<LayeredArrival> arrival = ways_.arrival(played.parameters, searched_);
    if (!arrival) {
      ++generation_.missed;
      return;
    }
    const bool copy = is_copy(arrival->rolled.motion.clip, apart);
    if (copy) ++generation_.near_copies;
    if (copy && copies == nullptr) return;
    Candidate candidate = make_layered(task_, played.parameters, std::move(*arrival));
    candidate.arm_collision->searches = played.feedback_rounds;
    (copy ? *copies : all()).push_back(std::move(candidate));
  }

  const Task& task_;
  const LayeredWays& ways_;
  LayeredWay searched_;
  UpperSearch& search_;
  Generation& generation_;
};

// Where some candidate keeps to its joints' limits, those that do not are not delivered.
void keep_within_limits(Generation& generation) {
  const auto passes = [](const Candidate& candidate) {
    return !candidate.measures.over_limit.empty();
  };
  std::vector<Candidate>& all = generation.candidates;
  if (std::all_of(all.begin(), all.end(), passes)) return;
  generation.over_limit += static_cast<int>(std::erase_if(all, passes));
}

// Searches one way, and keeps what it comes to.
void search_way(const Task& task, const LayeredProblem& problem, const LayeredWays& ways,
                LayeredWay way, ArmLibraries& libraries, const Progress& progress,
                Generation& generation) {
  UpperSearch search(task, problem, ways, way, libraries);
  const SearchResult found = search.run(progress);
  generation.evaluations += found.evaluations;
  generation.generations = found.generations;
  generation.rejected_nan += found.rejected_nan;
  generation.end = found.end;
  generation.best_seen = search.as_searched(found.best_seen.point);
  generation.best_seen_score = found.best_seen.score;
  generation.missed = generation.over_limit = 0;
  Choice choice = search.choice(found);
  const int taken = LayeredDelivery(task, ways, way, search, generation).collect(choice);
  if (problem.reach.hold_limits) keep_within_limits(generation);
  choice.similar = count_similar(choice, generation.candidates, taken);
  generation.fewer = why_fewer(task, generation, choice);
}

void finish(const LayeredProblem& problem, Generation& generation) {
  std::stable_sort(generation.candidates.begin(), generation.candidates.end(), ranks_before);
  const double miss = miss_of(generation.candidates.front());
  const bool met = problem.in_reach && miss <= kReachTolerance;
  generation.status = status_of(met, generation.candidates);
  generation.remaining_distance = met ? 0.0 : miss;
}

}  // namespace

Result<Generation> generate_layered(const Task& task, const Progress& progress) {
  const Result<LayeredProblem> problem = make_layered_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  ArmLibraries libraries(task, *problem);
  const LayeredWays ways(*problem);
  Generation generation;
  generation.duration = problem->reach.duration;
  for (const LayeredWay way : {LayeredWay::layers, LayeredWay::body}) {
    if (way == LayeredWay::layers && !problem->in_reach) continue;
    search_way(task, *problem, ways, way, libraries, progress, generation);
    if (!generation.candidates.empty() || generation.end == SearchEnd::cancelled) break;
  }
  if (generation.candidates.empty()) {
    const Parameters nearest = start_values(problem->layers);
    generation.candidates.push_back(make_layered(task, nearest, ways.any_arrival(nearest)));
  }
  finish(*problem, generation);
  generation.cells_searched = libraries.cells_searched();
  libraries.keep();
  return generation;
}

Result<Generation> regenerate_layered(const Task& task, const Parameters& parameters) {
  const Result<LayeredProblem> problem = make_layered_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  if (const auto checked = check_parameters(problem->layers, parameters); !checked) {
    return tl::unexpected(checked.error());
  }
  Generation generation;
  generation.duration = problem->reach.duration;
  const LayeredWays ways(*problem);
  generation.candidates.push_back(make_layered(task, parameters, ways.any_arrival(parameters)));
  finish(*problem, generation);
  return generation;
}

}  // namespace shigusa
