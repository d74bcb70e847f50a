// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <optional>
#include <shigusa/run.hpp>
#include <utility>

#include "candidate.hpp"
#include "core/index.hpp"
#include "criteria/user_criteria.hpp"
#include "generate/layered_approaches.hpp"
#include "layered_search.hpp"
#include "paper/limb_library.hpp"
#include "planner.hpp"

namespace shigusa {
namespace {

bool searches_paper_code(const Task& task) { return info_of(search_of(task)).paper_code; }

// Archived postures considered per requested candidate.
constexpr int kPickedPerCandidate = 2;

// The libraries of the arms that have a goal and are moved by weights.
class ArmLibraries {
 public:
  ArmLibraries(const Task& task, const LayeredProblem& problem) : store_(task.layers.store) {
    for (std::size_t g = 0; g < problem.arms.size(); ++g) {
      const Layer& layer = problem.layers[1 + g];
      if (!searches(layer, ParameterKind::weight)) continue;
      libraries_.emplace_back(problem.arm_bodies[g], LimbLibrarySettings{
                                                         .search = task.layers.limb_search,
                                                         .criteria = layer.criteria,
                                                         .batch = task.batch,
                                                     });
      names_.push_back(limb_file_name(layer.name, libraries_[g].hash()));
      take_stored(g);
      found_ += libraries_[g].cells_built();
    }
  }

  // The weights (goals) for the hands' final positions: the lower layer's weights are constant
  // during a motion.
  std::vector<ArmWeights> choose(std::span<const Vec3d> hands) {
    std::vector<ArmWeights> arms;
    for (std::size_t g = 0; g < libraries_.size(); ++g) {
      const int cell = libraries_[g].cell_of(hands[g]);
      arms.push_back(arm_weights(libraries_[g].genes(cell)));
    }
    return arms;
  }

  // Cells that were in no store; to be called before keep().
  [[nodiscard]] int cells_searched() const {
    int built = 0;
    for (const LimbLibrary& library : libraries_) built += library.cells_built();
    return built - found_;
  }

  // Stores the new cells, together with those stored by other processes meanwhile.
  void keep() {
    if (cells_searched() == 0 || !store_.save) return;
    for (std::size_t g = 0; g < libraries_.size(); ++g) {
      take_stored(g);
      store_.save(names_[g], libraries_[g].bytes());
    }
  }

 private:
  void take_stored(std::size_t goal) {
    if (!store_.load) return;
    // a damaged or old file is ignored, and replaced at the next save
    if (const auto bytes = store_.load(names_[goal])) libraries_[goal].take(*bytes);
  }

  LimbStore store_;
  std::vector<LimbLibrary> libraries_;  // (goals)
  std::vector<std::string> names_;
  int found_ = 0;  // cells loaded from the store
};

// The search of the upper layer on one approach; for LayeredApproach::body it searches weights
// alone.
class UpperSearch {
 public:
  UpperSearch(const Task& task, const LayeredProblem& problem, LayeredApproach approach,
              RunSettings run, ArmLibraries& libraries)
      : task_(task),
        problem_(problem),
        run_(std::move(run)),
        layers_(approach == LayeredApproach::layers),
        genes_(searched_genes(problem)),
        archive_(task, problem.reach.goals.front().effector),
        scorer_(problem, problem.layers[0].criteria, task.batch,
                [&libraries](std::span<const Vec3d> hands) { return libraries.choose(hands); }) {
    if (layers_) return;
    std::erase_if(genes_, [&problem](std::size_t gene) {
      return problem.layers[0].parameters[gene].kind == ParameterKind::contraction;
    });
  }

  SearchResult run(const Progress& progress) {
    SearchProblem searched;
    searched.genes = static_cast<int>(genes_.size());
    searched.evaluate = [this](std::span<const double> points, std::span<double> scores) {
      std::vector<LayeredValues> parameters;
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
    const int evaluations = run_.evaluations.value_or(usual_evaluations(task_));
    return run_search(task_, run_, searched, evaluations, !run_.evaluations, progress);
  }

  // The distinct postures to expand, best first.
  [[nodiscard]] Selection selection(const SearchResult& found) const {
    return keeps_ends() ? distinct_postures(archive_, kPickedPerCandidate * task_.candidates)
                        : Selection{.picked = ranked_population(found)};
  }

  // The parameter values of a point, including the results of the layers below.
  Expanded expanded(std::span<const double> point) {
    if (!layers_) return {parameters_of(problem_.layers, whole(decoded(point)))};
    LayeredScorer::Played played =
        scorer_.play(decoded(point), {.rounds = task_.layers.feedback_rounds,
                                      .search = task_.layers.limb_search,
                                      .seed = run_.seed});
    return {parameters_of(problem_.layers, std::move(played.values)), played.searches};
  }
  // The values of a point as scored by the search.
  Parameters as_searched(std::span<const double> point) {
    const LayeredValues upper = decoded(point);
    return parameters_of(problem_.layers,
                         layers_ ? scorer_.play(upper, {.rounds = 0}).values : whole(upper));
  }

 private:
  [[nodiscard]] bool keeps_ends() const { return traits_of(task_.preset).natural; }
  [[nodiscard]] LayeredValues decoded(std::span<const double> point) const {
    return decode_searched(problem_, genes_, point, searches_paper_code(task_));
  }

  // the upper layer's values with start values for the layers below
  [[nodiscard]] LayeredValues whole(const LayeredValues& upper) const {
    return below_upper(start_values(problem_.layers), upper);
  }

  void score_bodies(std::span<const LayeredValues> parameters, std::span<double> scores) {
    const CriteriaSettings& criteria = problem_.layers[0].criteria;
    const std::size_t dofs = postures_.size() / scores.size();
    std::vector<std::optional<Motion>> motions(scores.size());
    parallel_for(static_cast<int>(scores.size()), task_.batch.threads, [&](int i, int) {
      const auto k = index(i);
      auto arrival = body_arrival(problem_, whole(parameters[k]));
      if (!arrival) return;
      copy_end(arrival->rolled.motion.clip, std::span(postures_).subspan(k * dofs, dofs));
      motions[k] = std::move(arrival->rolled.motion);
    });
    score_motions(task_.body, motions, criteria, problem_.reach.context, task_.batch.threads,
                  scores);
  }

  const Task& task_;
  const LayeredProblem& problem_;
  RunSettings run_;
  bool layers_;
  std::vector<std::size_t> genes_;
  Archive archive_;
  std::vector<float> postures_;
  LayeredScorer scorer_;
};

class LayeredPlanner : public Planner {
 public:
  explicit LayeredPlanner(const Problem& problem)
      : posed_(problem),
        problem_(in_layers(problem.reach, problem.plan)),
        libraries_(problem.task, problem_) {
    if (problem_.in_reach) tried_.push_back(LayeredApproach::layers);
    tried_.push_back(LayeredApproach::body);
  }

  [[nodiscard]] bool in_reach() const override { return problem_.in_reach; }
  [[nodiscard]] std::size_t approaches() const override { return tried_.size(); }
  bool go_by_other_posture(int other) override { return other == 0; }

  Found search(const RunSettings& run, std::size_t approach, const Progress& progress) override {
    search_.emplace(posed_.task, problem_, tried_[approach], run, libraries_);
    Found found{.result = search_->run(progress), .selection = {}, .best_seen = {}};
    found.selection = search_->selection(found.result);
    found.best_seen = search_->as_searched(found.result.best_seen.point);
    found.best_seen_score = found.result.best_seen.score;
    return found;
  }

  Expanded expand(std::span<const double> point) override { return search_->expanded(point); }

  [[nodiscard]] std::optional<Arrival> arrival(const Parameters& values,
                                               std::size_t last) const override {
    return layered_arrival(problem_, layered_values(problem_.layers, values), tried_[last]);
  }
  [[nodiscard]] Arrival nearest(const Parameters& values) const override {
    return nearest_layered_arrival(problem_, layered_values(problem_.layers, values));
  }

  [[nodiscard]] Candidate candidate(const Expanded& expanded, Arrival arrival) const override {
    const ReachProblem& approach = *arrival.approach;
    Candidate candidate =
        make_candidate(posed_, approach, expanded.values, std::move(arrival.rolled));
    ArmCollision arms{.depth = -std::numeric_limits<double>::infinity(),
                      .searches = expanded.searches};
    for (const ReachGoal& goal : approach.goals) {
      const BodyModel& body = posed_.task.body;
      const Effector& hand = body.effectors()[index(goal.effector)];
      arms.depth = max(arms.depth, collision_depth(body, candidate.motion.clip, hand));
    }
    arms.left = arms.depth > kCollisionDepth;
    candidate.arm_collision = arms;
    return candidate;
  }

  void finish(GenerateResult& generation) override {
    generation.log.cells_searched = libraries_.cells_searched();
    libraries_.keep();
  }

 private:
  const Problem& posed_;
  LayeredProblem problem_;  // the problem in layers
  ArmLibraries libraries_;
  std::vector<LayeredApproach> tried_;
  std::optional<UpperSearch> search_;
};

}  // namespace

std::unique_ptr<Planner> make_layered_planner(const Problem& problem) {
  return std::make_unique<LayeredPlanner>(problem);
}

}  // namespace shigusa
