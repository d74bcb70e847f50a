// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/hierarchy/layered_generator.hpp>
#include <shigusa/rollout/reachability.hpp>
#include <utility>

#include "candidate.hpp"
#include "layered_search.hpp"
#include "ways.hpp"

namespace shigusa {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

SearchMethod search_of(const Task& task) { return task.search.value_or(SearchMethod::paper_ga); }

bool searches_paper_code(const Task& task) {
  const SearchMethod method = search_of(task);
  return method == SearchMethod::paper_ga || method == SearchMethod::annealing ||
         method == SearchMethod::random;
}

SearchResult run_search(const Task& task, const SearchProblem& problem, const Progress& progress) {
  const SearchMethod method = search_of(task);
  const int evaluations = task.evaluations.value_or(kFlatEvaluations);
  if (method == SearchMethod::paper_ga || method == SearchMethod::log_ga) {
    if (!task.evaluations) return genetic_search(problem, task.genetic, progress);
    return restarted_genetic_search(problem, task.genetic, evaluations, progress);
  }
  return search(method, problem, evaluations, task.genetic.seed, progress);
}

LayeredCandidate make_layered(const Task& task, const LayeredProblem& problem,
                              const LayerParameters& upper, LayeredScorer::Played played) {
  LayeredCandidate candidate{
      make_candidate(task, problem.reach, {}, std::move(played.motion)), {}, -1e9, 0, false};
  candidate.layered = {upper, std::move(played.arms)};
  for (const ReachGoal& goal : problem.reach.goals) {
    const Effector& hand = task.body.effectors()[index(goal.effector)];
    const double depth = collision_depth(task.body, candidate.motion.clip, hand);
    candidate.collision = max(candidate.collision, depth);
  }
  candidate.feedback_rounds = played.feedback_rounds;
  candidate.collision_left = candidate.collision > kCollisionDepth;
  return candidate;
}

void finish(LayeredGeneration& generation) {
  std::stable_sort(generation.candidates.begin(), generation.candidates.end(),
                   [](const LayeredCandidate& a, const LayeredCandidate& b) {
                     return ranking(a.score) < ranking(b.score);
                   });
  const double miss = miss_of(generation.candidates.front());
  const bool met = miss <= kReachTolerance;
  generation.status = met ? ReachStatus::reached : ReachStatus::unreachable;
  generation.remaining_distance = met ? 0.0 : miss;
}

// The libraries of the arms that have a goal.
class ArmLibraries {
 public:
  ArmLibraries(const Task& task, const LayeredProblem& problem, const LayeredSettings& settings)
      : store_(settings.store) {
    for (std::size_t g = 0; g < problem.arms.size(); ++g) {
      libraries_.emplace_back(problem.arm_bodies[g], LimbLibrarySettings{
                                                         .search = settings.limb_search,
                                                         .criteria = arm_layer(problem, g).criteria,
                                                         .batch = task.batch,
                                                     });
      names_.push_back(limb_file_name(arm_layer(problem, g).name, libraries_[g].hash()));
      take_stored(g);
      found_ += libraries_[g].cells_built();
    }
  }

  // By where the hands end: the lower layer's weights stay the same during a motion.
  std::vector<ArmWeights> choose(std::span<const HandPath> paths) {
    std::vector<ArmWeights> arms;
    for (std::size_t g = 0; g < paths.size(); ++g) {
      const int cell = libraries_[g].cell_of(paths[g].back());
      arms.push_back(arm_weights(libraries_[g].genes(cell)));
    }
    return arms;
  }

  // Stores what is new, beside what others have stored meanwhile.
  void keep() {
    if (cells_searched() == 0 || !store_.save) return;
    for (std::size_t g = 0; g < libraries_.size(); ++g) {
      take_stored(g);
      store_.save(names_[g], libraries_[g].bytes());
    }
  }

  // Counted before keep().
  [[nodiscard]] int cells_searched() const {
    int built = 0;
    for (const LimbLibrary& library : libraries_) built += library.cells_built();
    return built - found_;
  }

 private:
  void take_stored(std::size_t goal) {
    if (!store_.load) return;
    // damaged or old ones are left alone, and replaced when something new is stored
    if (const auto bytes = store_.load(names_[goal])) libraries_[goal].take(*bytes);
  }

  LimbStore store_;
  std::vector<LimbLibrary> libraries_;  // (goals)
  std::vector<std::string> names_;
  int found_ = 0;  // cells that were stored
};

Result<void> check_parameters(const LayeredProblem& problem, const LayeredParameters& parameters) {
  const ReducedBody& body = problem.layers[0].body;
  if (parameters.upper.joints.size() != body.dofs.size() ||
      parameters.upper.contractions.size() != body.limbs.size() ||
      parameters.arms.size() != problem.arms.size()) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} freedoms, {} limbs and {} arms, for layers of {}, {} and {}",
                            parameters.upper.joints.size(), parameters.upper.contractions.size(),
                            parameters.arms.size(), body.dofs.size(), body.limbs.size(),
                            problem.arms.size()));
  }
  std::vector<JointWeight> weights = parameters.upper.joints;
  for (const ArmWeights& arm : parameters.arms)
    weights.insert(weights.end(), arm.begin(), arm.end());
  for (const JointWeight& joint : weights) {
    if (joint.weight >= kWeightMin && joint.weight <= kWeightMax) continue;
    return fail(ErrorCode::invalid_argument, fmt::format("weight is {}; allowed are {:g} to {:g}",
                                                         joint.weight, kWeightMin, kWeightMax));
  }
  for (const double contraction : parameters.upper.contractions) {
    if (contraction >= 0.0 && contraction <= 1.0) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("contraction is {}; allowed are 0 to 1", contraction));
  }
  return {};
}

}  // namespace

Result<LayeredProblem> make_layered_problem(const Task& task, const LayeredSettings& settings) {
  Result<ReachProblem> reach = make_problem(task);
  if (!reach) return tl::unexpected(reach.error());
  Result<std::vector<Layer>> layers =
      paper_layers(task.body, task_criteria(task), settings.reading);
  if (!layers) return tl::unexpected(layers.error());
  LayeredProblem problem{.reach = std::move(*reach),
                         .layers = std::move(*layers),
                         .limbs = find_limbs(task.body).value(),
                         .arms = {},
                         .arm_bodies = {}};
  for (const ReachGoal& goal : problem.reach.goals) {
    for (std::size_t a = 0; a < problem.limbs.arms.size(); ++a) {
      if (problem.limbs.arms[a].effector != goal.effector) continue;
      problem.arms.push_back(static_cast<int>(a));
      problem.arm_bodies.push_back(arm_body(task.body, problem.limbs.arms[a]));
    }
  }
  // the straight way, or around the body; out of reach, to the closest point there is
  problem.reach = ways_to_goal(problem.reach, closest_reach(problem.reach)).front();
  return problem;
}

Result<LayeredGeneration> generate_layered(const Task& task, const LayeredSettings& settings,
                                           const Progress& progress) {
  const Result<LayeredProblem> problem = make_layered_problem(task, settings);
  if (!problem) return tl::unexpected(problem.error());
  const Layer& upper = problem->layers[0];
  const std::vector<std::size_t> searched = searched_genes(*problem);
  ArmLibraries libraries(task, *problem, settings);
  LayeredScorer scorer(*problem, upper.criteria, task.batch.threads,
                       [&](std::span<const HandPath> paths) { return libraries.choose(paths); });
  const auto decoded = [&](std::span<const double> point) {
    return decode_searched(*problem, searched, point, searches_paper_code(task));
  };
  SearchProblem upper_search;
  upper_search.genes = static_cast<int>(searched.size());
  upper_search.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    std::vector<LayerParameters> parameters;
    for (std::size_t i = 0; i < scores.size(); ++i) {
      parameters.push_back(decoded(points.subspan(i * searched.size(), searched.size())));
    }
    scorer.score(parameters, scores);
  };
  const SearchResult found = run_search(task, upper_search, progress);
  LayeredGeneration generation;
  generation.duration = problem->reach.duration;
  generation.evaluations = found.evaluations;
  generation.generations = found.generations;
  generation.rejected_nan = found.rejected_nan;
  generation.end = found.end;
  generation.best_seen_score = found.best_seen.score;
  const LayeredScorer::Feedback feedback{settings.feedback_rounds, settings.limb_search};
  for (const Individual& individual : ranked_population(found)) {
    if (static_cast<int>(generation.candidates.size()) >= task.candidates) break;
    const LayerParameters parameters = decoded(individual.point);
    LayeredScorer::Played played = scorer.play(parameters, feedback);
    if (!played.motion.outcome.met(problem->reach.tolerance)) {
      ++generation.missed;
      continue;
    }
    const Clip& clip = played.motion.motion.clip;
    const auto is_copy = [&clip](const LayeredCandidate& better) {
      return largest_distance(better.motion.clip, clip) < kDistinctPosture;
    };
    if (std::any_of(generation.candidates.begin(), generation.candidates.end(), is_copy)) {
      ++generation.near_copies;
      continue;
    }
    generation.candidates.push_back(make_layered(task, *problem, parameters, std::move(played)));
  }
  if (generation.candidates.empty()) {
    // the one that comes nearest to its goals
    const LayerParameters best = decoded(found.best_seen.point);
    generation.candidates.push_back(make_layered(task, *problem, best, scorer.play(best)));
  }
  finish(generation);
  generation.cells_searched = libraries.cells_searched();
  libraries.keep();
  return generation;
}

Result<LayeredGeneration> regenerate_layered(const Task& task, const LayeredParameters& parameters,
                                             const LayeredSettings& settings) {
  const Result<LayeredProblem> problem = make_layered_problem(task, settings);
  if (!problem) return tl::unexpected(problem.error());
  if (const auto checked = check_parameters(*problem, parameters); !checked) {
    return tl::unexpected(checked.error());
  }
  LayeredGeneration generation;
  generation.duration = problem->reach.duration;
  LayeredScorer scorer(*problem, problem->layers[0].criteria, task.batch.threads,
                       [&](std::span<const HandPath>) { return parameters.arms; });
  generation.candidates.push_back(
      make_layered(task, *problem, parameters.upper, scorer.play(parameters.upper)));
  finish(generation);
  return generation;
}

}  // namespace shigusa
