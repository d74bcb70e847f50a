// SPDX-License-Identifier: MIT
#include "layered_search.hpp"

#include <algorithm>
#include <functional>
#include <shigusa/parallel.hpp>
#include <type_traits>
#include <utility>

#include "candidate.hpp"
#include "core/index.hpp"
#include "search/genetic.hpp"

namespace shigusa {
namespace {

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

// The cost of the torque that freedoms with a final angle take, by their layers' criteria: as the
// criterion Torque has it, but of these freedoms alone.
double own_torque(const LayeredProblem& problem, const Motion& motion) {
  const BodyModel& body = *problem.reach.body;
  double cost = 0.0;
  for (const Layer& layer : problem.layers) {
    double squares = 0.0;
    int count = 0;
    for (const ParameterInfo& info : layer.parameters) {
      if (info.kind != ParameterKind::final_angle) continue;
      const int dof = body.find_dof(info.name).value();
      for (int f = 0; f < motion.clip.frames; ++f, ++count) {
        const double tau = motion.torques[index(f * motion.clip.dofs + dof)];
        const Dof& joint = body.dof(dof);
        const double load = tau / (tau > 0.0 ? joint.torque_positive : joint.torque_negative);
        squares += load * load;
      }
    }
    const CriteriaSettings& criteria = layer.criteria;
    if (count == 0) continue;
    cost += criteria.torque_weight * min(1.0, sqrt(squares / count) / criteria.torque.share);
  }
  return cost;
}

// Each final angle of a limb that no goal moves takes this many motions to be found.
constexpr int kRestEvaluations = 40;

// Scores of motions by their final angles: `finals` is (scores × angles) rad.
using RestEvaluation = std::function<void(std::span<const double> finals, std::span<double>)>;

// The final angles that one freedom may have (rad).
struct Range {
  double low;
  double high;

  // rounding could take the last share beyond the range
  [[nodiscard]] double at(double share) const { return min(high, low + share * (high - low)); }
  [[nodiscard]] double share(double value) const {
    return high > low ? clamp((value - low) / (high - low), 0.0, 1.0) : 0.0;
  }
};

// Sets the final angles to those with the lowest score, searched from `finals` on by CMA-ES within
// their ranges. They stay if none is better, or where the layers have no final angles.
void search_finals(std::span<const Layer> layers, std::uint64_t seed, const RestEvaluation& score,
                   std::vector<double>& finals) {
  std::vector<Range> ranges;
  for (const Layer& layer : layers) {
    for (const ParameterInfo& info : layer.parameters) {
      if (info.kind == ParameterKind::final_angle) ranges.push_back({info.low, info.high});
    }
  }
  if (ranges.empty()) return;
  const auto angles_of = [&ranges](std::span<const double> points) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < points.size(); ++k) {
      angles.push_back(ranges[k % ranges.size()].at(points[k]));
    }
    return angles;
  };
  SearchProblem problem;
  problem.genes = static_cast<int>(ranges.size());
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    problem.start.push_back(ranges[k].share(finals[k]));
  }
  problem.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    score(angles_of(points), scores);
  };
  // no rounding of shares may lose the motion as it is
  double before = 0.0;
  score(finals, std::span(&before, 1));
  const SearchResult found =
      search(SearchMethod::cma_es, problem, kRestEvaluations * problem.genes, seed);
  if (found.best_seen.score < before) finals = angles_of(found.best_seen.point);
}

}  // namespace

std::vector<std::size_t> searched_genes(const LayeredProblem& problem) {
  const Layer& layer = problem.layers[0];
  std::vector<std::size_t> searched;
  for (std::size_t g = 0; g < layer.parameters.size(); ++g) {
    const ParameterInfo& info = layer.parameters[g];
    const bool used = std::any_of(info.applies_to.begin(), info.applies_to.end(), [&](int to) {
      if (info.kind == ParameterKind::weight) return has_use(problem, to);
      const BodyLimb& limb = layer.body.limbs[index(to)].joints;
      return limb.kind == LimbKind::leg || has_goal(problem, limb);
    });
    if (used) searched.push_back(g);
  }
  return searched;
}

Parameters decode_searched(const LayeredProblem& problem, std::span<const std::size_t> searched,
                           std::span<const double> point, bool paper) {
  const Layer& layer = problem.layers[0];
  const auto spread = [&](auto rest, const auto& values) {
    std::vector<typename std::decay_t<decltype(values)>::value_type> all;
    for (const ParameterInfo& info : layer.parameters) all.push_back(rest(info.kind));
    for (std::size_t k = 0; k < searched.size(); ++k) all[searched[k]] = values[k];
    return all;
  };
  const auto moves = [](ParameterKind kind) { return kind == ParameterKind::weight; };
  if (!paper) {
    const std::vector<double> values(point.begin(), point.end());
    // the middle is a weight of 1
    return decode_layer_point(
        layer, spread([&](ParameterKind kind) { return moves(kind) ? 0.5 : 0.0; }, values));
  }
  const Genome genes = genome_of_point(point, kPaperBitsPerGene);
  return decode_layer_genes(
      layer,
      spread([&](ParameterKind kind) { return static_cast<std::uint16_t>(moves(kind) ? 1 : 0); },
             genes));
}

Parameters below_upper(Parameters start, const Parameters& upper) {
  start.joints = upper.joints;
  start.contractions = upper.contractions;
  return start;
}

LayeredScorer::LayeredScorer(const LayeredProblem& problem, const CriteriaSettings& criteria,
                             int threads, ChooseArms choose)
    : problem_(&problem),
      criteria_(&criteria),
      threads_(threads),
      choose_(std::move(choose)),
      start_(start_values(problem.layers)),
      workers_(index(thread_count(threads))) {}

LayeredScorer::Worker& LayeredScorer::worker(int at) {
  std::unique_ptr<Worker>& own = workers_[index(at)];
  if (own) return *own;
  own = std::make_unique<Worker>(Worker{.player = LayeredPlayer(*problem_), .swivels = {}});
  for (std::size_t g = 0; g < swivel_goals(); ++g) {
    own->swivels.emplace_back(problem_->arm_bodies[g],
                              problem_->limbs.arms[index(problem_->arms[g])],
                              problem_->layers[1 + g]);
  }
  return *own;
}

ArmFeedback LayeredScorer::bare(std::size_t goal, const ReducedClip& clip, HandPath path) const {
  return {.arm = &problem_->arm_bodies[goal],
          .path = std::move(path),
          .turn = hand_turn(*problem_, clip, goal),
          .duration = problem_->reach.duration,
          .obstacles = {},
          .limb = {}};
}

double LayeredScorer::judged(const RolledOut& played) const {
  const double worst = worst_score(*criteria_);
  if (!played.outcome.met(problem_->reach.tolerance)) {
    return worst + min(played.outcome.path_error, 1.0);
  }
  const BodyModel& body = *problem_->reach.body;
  const double score = score_motion(body, played.motion, *criteria_).total;
  if (!problem_->reach.hold_limits) return score;
  double excess = 0.0;
  for (const LimitExcess& over : limit_excess(body, played.motion.clip)) excess += over.excess;
  return score + min(kOverLimitCost * excess, kOverLimitMost);
}

std::vector<LayeredScorer::UpperMotion> LayeredScorer::run_upper(
    std::span<const Parameters> parameters, std::span<double> scores) {
  std::vector<UpperMotion> uppers(scores.size());
  const double worst = worst_score(*criteria_);
  const ReachTolerance& tolerance = problem_->reach.tolerance;
  parallel_for(static_cast<int>(scores.size()), threads_, [&](int i, int thread) {
    auto& [clip, paths] = uppers[index(i)];
    LayeredPlayer& player = worker(thread).player;
    player.run_upper(parameters[index(i)], clip);
    const bool kept = clip.path_error <= tolerance.path && clip.foot_error <= kReachTolerance;
    const bool leads = kept && player.check_pelvis(clip).in_reach;
    scores[index(i)] = worst + min(clip.path_error + clip.foot_error, 1.0);
    if (leads) paths = player.hand_paths(clip);
  });
  return uppers;
}

void LayeredScorer::score(std::span<const Parameters> parameters, std::span<double> scores,
                          std::span<float> postures) {
  std::vector<UpperMotion> uppers = run_upper(parameters, scores);
  const std::size_t dofs = postures.empty() ? 0 : problem_->reach.body->dofs().size();
  // arms are chosen one after the other, as a library may have to be built
  std::vector<Parameters> below(scores.size(), start_);
  for (std::size_t k = 0; k < scores.size(); ++k) {
    if (!uppers[k].paths.empty() && choose_) below[k].arms = choose_(uppers[k].paths);
  }
  parallel_for(static_cast<int>(scores.size()), body_threads(), [&](int i, int thread) {
    const auto k = index(i);
    auto& [clip, paths] = uppers[k];
    if (paths.empty()) return;
    Worker& own = worker(thread);
    for (std::size_t g = 0; g < swivel_goals(); ++g) {
      below[k].swivels[g] = own.swivels[g].coarse(bare(g, clip, std::move(paths[g])));
    }
    const RolledOut played = own.player.expand_freeing(clip, below[k]);
    scores[k] = judged(played);
    copy_end(played.motion.clip, postures.subspan(k * dofs, dofs));
  });
}

Expanded LayeredScorer::play(const Parameters& upper, const Feedback& feedback) {
  LayeredPlayer& player = worker(0).player;
  ReducedClip clip;
  player.run_upper(upper, clip);
  const std::vector<HandPath> paths = player.hand_paths(clip);
  Expanded played{.values = below_upper(start_, upper)};
  if (choose_) played.values.arms = choose_(paths);
  for (std::size_t g = 0; g < swivel_goals(); ++g) {
    played.values.swivels[g] = worker(0).swivels[g].coarse(bare(g, clip, paths[g]));
  }
  if (!player.expand_freeing(clip, played.values).outcome.met(problem_->reach.tolerance)) {
    return played;
  }
  retake_weights(clip, feedback, played);
  if (feedback.coarse) return played;
  refine_swivels(clip, played.values);
  settle_rest(clip, feedback, played.values);
  return played;
}

void LayeredScorer::retake_weights(const ReducedClip& clip, const Feedback& feedback,
                                   Expanded& played) {
  LayeredPlayer& player = worker(0).player;
  const std::vector<HandPath> paths = player.hand_paths(clip);
  const BodyModel& body = *problem_->reach.body;
  RolledOut motion = player.expand(clip, played.values);
  for (std::size_t g = 0; g < played.values.arms.size(); ++g) {
    const Effector& hand = body.effectors()[index(problem_->reach.goals[g].effector)];
    double weight = kCollisionWeight;
    for (int round = 0; round < feedback.rounds; ++round) {
      if (collision_depth(body, motion.motion.clip, hand) <= kCollisionDepth) break;
      const ArmFeedback report = arm_feedback(*problem_, g, paths[g], motion.motion.clip);
      if (unavoidable_depth(report) > kCollisionDepth) break;
      ++played.searches;
      const std::optional<FoundArm> found = search_free_arm(
          report, problem_->layers[1 + g].criteria, weight, feedback.search, threads_);
      if (!found) break;
      played.values.arms[g] = arm_weights(found->genes);
      motion = player.expand_freeing(clip, played.values);
      weight *= kCollisionGrowth;
    }
  }
}

void LayeredScorer::refine_swivels(const ReducedClip& clip, Parameters& parameters) {
  Worker& own = worker(0);
  const std::vector<HandPath> paths = own.player.hand_paths(clip);
  for (std::size_t g = 0; g < swivel_goals(); ++g) {
    const RolledOut played = own.player.expand(clip, parameters);
    parameters.swivels[g] = own.swivels[g].fine(
        arm_feedback(*problem_, g, paths[g], played.motion.clip, hand_turn(*problem_, clip, g)));
  }
}

void LayeredScorer::settle_rest(const ReducedClip& clip, const Feedback& feedback,
                                Parameters& parameters) {
  const std::size_t angles = parameters.finals.size();
  const BodyModel& body = *problem_->reach.body;
  const RestEvaluation score = [&](std::span<const double> finals, std::span<double> scores) {
    parallel_for(static_cast<int>(scores.size()), body_threads(), [&](int i, int thread) {
      Parameters tried = parameters;
      const auto first = finals.subspan(index(i) * angles, angles);
      tried.finals.assign(first.begin(), first.end());
      const RolledOut played = worker(thread).player.expand(clip, tried);
      double depth = 0.0;
      for (const BodyLimb& arm : problem_->limbs.arms) {
        if (has_goal(*problem_, arm)) continue;
        const Effector& hand = body.effectors()[index(arm.effector)];
        depth = max(depth, collision_depth(body, played.motion.clip, hand));
      }
      scores[index(i)] = judged(played) + own_torque(*problem_, played.motion) +
                         kSwivelCollisionWeight * clamp(depth / kCollisionFull, 0.0, 1.0);
    });
  };
  search_finals(problem_->layers, feedback.seed, score, parameters.finals);
}

}  // namespace shigusa
