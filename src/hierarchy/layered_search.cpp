// SPDX-License-Identifier: MIT
#include "layered_search.hpp"

#include <algorithm>
#include <shigusa/core/parallel.hpp>
#include <shigusa/search/genetic.hpp>
#include <type_traits>
#include <utility>

namespace shigusa {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool has_goal(const LayeredProblem& problem, const BodyLimb& arm) {
  return std::any_of(problem.arms.begin(), problem.arms.end(),
                     [&](int a) { return problem.limbs.arms[index(a)].effector == arm.effector; });
}

// Whether a freedom of the upper layer's body moves anything that must be somewhere.
bool has_use(const LayeredProblem& problem, int dof) {
  for (const BodyLimb& arm : problem.limbs.arms) {
    const Dof& flexion = problem.reach.body->dof(arm.flexion);
    const Dof& abduction = problem.reach.body->dof(arm.abduction);
    const std::string& name = problem.layers[0].body.dofs[index(dof)].name;
    if (name == flexion.name || name == abduction.name) return has_goal(problem, arm);
  }
  return true;
}

}  // namespace

std::vector<std::size_t> searched_genes(const LayeredProblem& problem) {
  const Layer& layer = problem.layers[0];
  std::vector<std::size_t> searched;
  for (std::size_t g = 0; g < layer.genes.size(); ++g) {
    const LayerGene& gene = layer.genes[g];
    const bool used = std::any_of(gene.applies_to.begin(), gene.applies_to.end(), [&](int to) {
      if (gene.kind == LayerGeneKind::weight) return has_use(problem, to);
      const BodyLimb& limb = layer.body.limbs[index(to)].joints;
      return limb.kind == LimbKind::leg || has_goal(problem, limb);
    });
    if (used) searched.push_back(g);
  }
  return searched;
}

LayerParameters decode_searched(const LayeredProblem& problem,
                                std::span<const std::size_t> searched,
                                std::span<const double> point, bool paper) {
  const Layer& layer = problem.layers[0];
  const auto spread = [&](auto rest, const auto& values) {
    std::vector<typename std::decay_t<decltype(values)>::value_type> all;
    for (const LayerGene& gene : layer.genes) all.push_back(rest(gene.kind));
    for (std::size_t k = 0; k < searched.size(); ++k) all[searched[k]] = values[k];
    return all;
  };
  const auto moves = [](LayerGeneKind kind) { return kind == LayerGeneKind::weight; };
  if (!paper) {
    const std::vector<double> values(point.begin(), point.end());
    // the middle is a weight of 1
    return decode_layer_point(
        layer, spread([&](LayerGeneKind kind) { return moves(kind) ? 0.5 : 0.0; }, values));
  }
  const Genome genes = genome_of_point(point, kPaperBitsPerGene);
  return decode_layer_genes(
      layer,
      spread([&](LayerGeneKind kind) { return static_cast<std::uint16_t>(moves(kind) ? 1 : 0); },
             genes));
}

LayeredScorer::LayeredScorer(const LayeredProblem& problem, const CriteriaSettings& criteria,
                             int threads, ChooseArms choose)
    : problem_(&problem),
      criteria_(&criteria),
      threads_(threads),
      choose_(std::move(choose)),
      players_(index(thread_count(threads))) {}

void LayeredScorer::score(std::span<const LayerParameters> parameters, std::span<double> scores) {
  const int count = static_cast<int>(scores.size());
  const auto player = [this](int worker) -> LayeredPlayer& {
    std::unique_ptr<LayeredPlayer>& own = players_[index(worker)];
    if (!own) own = std::make_unique<LayeredPlayer>(*problem_);
    return *own;
  };
  // first where the layers' trunk goes …
  std::vector<ReducedClip> clips(scores.size());
  std::vector<std::vector<HandPath>> paths(scores.size());
  const double worst = worst_score(*criteria_);
  const ReachTolerance& tolerance = problem_->reach.tolerance;
  parallel_for(count, threads_, [&](int i, int worker) {
    const auto k = index(i);
    player(worker).run_upper(parameters[k], clips[k]);
    const bool kept =
        clips[k].path_error <= tolerance.path && clips[k].foot_error <= kReachTolerance;
    const bool leads = kept && player(worker).check_pelvis(clips[k]).in_reach;
    scores[k] = worst + min(clips[k].path_error + clips[k].foot_error, 1.0);
    if (leads) paths[k] = player(worker).hand_paths(clips[k]);
  });
  // … then what arms it needs, one after the other as a library may have to be built …
  std::vector<std::vector<ArmWeights>> arms(scores.size());
  for (std::size_t k = 0; k < scores.size(); ++k) {
    if (!paths[k].empty()) arms[k] = choose_(paths[k]);
  }
  // … then the whole body; a user's criteria are called by one thread
  const int threads = criteria_->user.empty() ? threads_ : 1;
  parallel_for(count, threads, [&](int i, int worker) {
    const auto k = index(i);
    if (paths[k].empty()) return;
    const RolledOut played = player(worker).expand_freeing(clips[k], arms[k]);
    scores[k] = played.outcome.met(tolerance)
                    ? score_motion(*problem_->reach.body, played.motion, *criteria_).total
                    : worst + min(played.outcome.path_error, 1.0);
  });
}

LayeredScorer::Played LayeredScorer::play(const LayerParameters& parameters,
                                          const Feedback& feedback) {
  if (!players_[0]) players_[0] = std::make_unique<LayeredPlayer>(*problem_);
  LayeredPlayer& player = *players_[0];
  ReducedClip clip;
  player.run_upper(parameters, clip);
  const std::vector<HandPath> paths = player.hand_paths(clip);
  Played played{.motion = {}, .arms = choose_(paths)};
  played.motion = player.expand_freeing(clip, played.arms);
  if (!played.motion.outcome.met(problem_->reach.tolerance)) return played;
  const BodyModel& body = *problem_->reach.body;
  for (std::size_t g = 0; g < paths.size(); ++g) {
    const Effector& hand = body.effectors()[index(problem_->reach.goals[g].effector)];
    double weight = kCollisionWeight;
    for (int round = 0; round < feedback.rounds; ++round) {
      if (collision_depth(body, played.motion.motion.clip, hand) <= kCollisionDepth) break;
      const ArmFeedback report = arm_feedback(*problem_, g, paths[g], played.motion.motion.clip);
      if (unavoidable_depth(report) > kCollisionDepth) break;
      ++played.feedback_rounds;
      const std::optional<FoundArm> found = search_free_arm(
          report, problem_->layers[1 + g].criteria, weight, feedback.search, threads_);
      if (!found) break;
      played.arms[g] = arm_weights(found->genes);
      played.motion = player.expand_freeing(clip, played.arms);
      weight *= kCollisionGrowth;
    }
  }
  return played;
}

}  // namespace shigusa
