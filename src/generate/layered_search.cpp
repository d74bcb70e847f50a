// SPDX-License-Identifier: MIT
#include "layered_search.hpp"

#include <algorithm>
#include <functional>
#include <shigusa/run.hpp>
#include <type_traits>
#include <utility>

#include "candidate.hpp"
#include "core/index.hpp"
#include "search/genetic.hpp"

namespace shigusa {
namespace {

// Whether a dof of the upper layer's body moves an effector with a goal, or a foot.
bool has_use(const LayeredProblem& problem, int dof) {
  for (const BodyLimb& arm : problem.limbs.arms) {
    const Dof& flexion = problem.reach.body->dof(arm.flexion);
    const Dof& abduction = problem.reach.body->dof(arm.abduction);
    const std::string& name = problem.layers[0].body.dofs[index(dof)].name;
    if (name == flexion.name || name == abduction.name) return has_goal(problem, arm);
  }
  return true;
}

// Evaluations spent per final angle of an idle limb.
constexpr int kRestEvaluations = 40;

// Scores of motions by their final angles: `finals` is (scores × angles) rad.
using RestEvaluation = std::function<void(std::span<const double> finals, std::span<double>)>;

// Range of one final angle (rad).
struct Range {
  double low;
  double high;

  // rounding could exceed the range at a share of 1
  [[nodiscard]] double at(double share) const { return min(high, low + share * (high - low)); }
  [[nodiscard]] double share(double value) const {
    return high > low ? clamp((value - low) / (high - low), 0.0, 1.0) : 0.0;
  }
};

// Replaces the final angles by the best found by CMA-ES within their ranges, starting at `finals`.
// They stay if none is better, or if the layers have no final angles.
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
  // the motion as it is, scored without the rounding of shares, must not be lost
  double before = 0.0;
  score(finals, std::span(&before, 1));
  const SearchResult found =
      search(SearchMethod::cma_es, problem, kRestEvaluations * problem.genes, seed);
  if (found.best_seen.score < before) finals = angles_of(found.best_seen.point);
}

std::vector<Vec3d> ends_of(std::span<const HandPath> paths) {
  std::vector<Vec3d> ends;
  for (const HandPath& path : paths) ends.push_back(path.back());
  return ends;
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

LayeredValues decode_searched(const LayeredProblem& problem, std::span<const std::size_t> searched,
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
    // 0.5 is a weight of 1
    return decode_layer_point(
        layer, spread([&](ParameterKind kind) { return moves(kind) ? 0.5 : 0.0; }, values));
  }
  const Genome genes = genome_of_point(point, kPaperBitsPerGene);
  return decode_layer_genes(
      layer,
      spread([&](ParameterKind kind) { return static_cast<std::uint16_t>(moves(kind) ? 1 : 0); },
             genes));
}

LayeredValues below_upper(LayeredValues start, const LayeredValues& upper) {
  start.joints = upper.joints;
  start.contractions = upper.contractions;
  return start;
}

LayeredScorer::LayeredScorer(const LayeredProblem& problem, const CriteriaSettings& criteria,
                             const BatchSettings& settings, ChooseArms choose)
    : problem_(&problem),
      criteria_(&criteria),
      threads_(settings.threads),
      choose_(std::move(choose)),
      start_(start_values(problem.layers)),
      player_(problem),
      batch_(player_.setup(), criteria, settings) {}

void LayeredScorer::Rows::add(const LayeredValues& parameters) {
  const auto append = [](std::vector<float>& rows, const std::vector<double>& row) {
    for (const double x : row) rows.push_back(static_cast<float>(x));
  };
  append(inverse_weights, upper_weights(parameters));
  append(contractions, parameters.contractions);
  append(finals, parameters.finals);
  append(swivels, parameters.swivels);
  for (const ArmWeights& arm : parameters.arms) append(arms, shigusa::inverse_weights(arm));
}

std::vector<ArmWeights> LayeredScorer::choose_arms(std::span<const Vec3d> hands) const {
  return choose_ ? choose_(hands) : start_.arms;
}

double LayeredScorer::judged(const RolledOut& played) const {
  const double worst = worst_score(*criteria_);
  if (!played.outcome.met(problem_->reach.tolerance)) {
    return worst + min(played.outcome.path_error, 1.0);
  }
  const BodyModel& body = *problem_->reach.body;
  const double score = score_motion(body, played.motion, *criteria_, problem_->reach.context).total;
  if (!problem_->reach.hold_limits) return score;
  double excess = 0.0;
  for (const LimitExcess& over : limit_excess(body, played.motion.clip)) excess += over.excess;
  return score + min(kOverLimitCost * excess, kOverLimitMost);
}

double LayeredScorer::score_alone(const LayeredValues& upper, std::span<float> posture) {
  ReducedClip<double> clip;
  player_.run_upper(upper, clip);
  const bool kept =
      clip.path_error <= problem_->reach.tolerance.path && clip.foot_error <= kReachTolerance;
  if (!kept || !player_.check_pelvis(clip).in_reach) {
    return worst_score(*criteria_) + min(clip.path_error + clip.foot_error, 1.0);
  }
  LayeredValues values = below_upper(start_, upper);
  values.arms = choose_arms(ends_of(player_.hand_paths(clip)));
  values.swivels = player_.find_swivels(clip);
  const RolledOut played = player_.expand_freeing(clip, values);
  copy_end(played.motion.clip, posture);
  return judged(played);
}

void LayeredScorer::score(std::span<const LayeredValues> parameters, std::span<double> scores,
                          std::span<float> postures) {
  if (!criteria_->user.empty()) {
    const std::size_t dofs = postures.size() / scores.size();
    for (std::size_t k = 0; k < scores.size(); ++k) {
      scores[k] = score_alone(parameters[k], postures.subspan(k * dofs, dofs));
    }
    return;
  }
  LayeredValues below = start_;
  below.arms.clear();
  below.swivels.clear();
  Rows rows;
  for (const LayeredValues& upper : parameters) rows.add(below_upper(below, upper));
  const auto choose = [this](std::span<const Vec3d> hands) {
    Rows chosen;
    LayeredValues arms;
    arms.arms = choose_arms(hands);
    chosen.add(arms);
    return chosen.arms;
  };
  batch_.score(rows.inputs(), choose, scores, postures);
}

LayeredScorer::Played LayeredScorer::play(const LayeredValues& upper, const Feedback& feedback) {
  ReducedClip<double> clip;
  player_.run_upper(upper, clip);
  Played played{.values = below_upper(start_, upper)};
  played.values.arms = choose_arms(ends_of(player_.hand_paths(clip)));
  played.values.swivels = player_.find_swivels(clip);
  if (!player_.expand_freeing(clip, played.values).outcome.met(problem_->reach.tolerance)) {
    return played;
  }
  retake_weights(clip, feedback, played);
  if (!feedback.seed) return played;
  refine_swivels(clip, played.values);
  settle_rest(clip, *feedback.seed, played.values);
  return played;
}

void LayeredScorer::retake_weights(const ReducedClip<double>& clip, const Feedback& feedback,
                                   Played& played) {
  if (played.values.arms.empty()) return;
  const std::vector<HandPath> paths = player_.hand_paths(clip);
  const BodyModel& body = *problem_->reach.body;
  RolledOut motion = player_.expand(clip, played.values);
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
      motion = player_.expand_freeing(clip, played.values);
      weight *= kCollisionGrowth;
    }
  }
}

void LayeredScorer::refine_swivels(const ReducedClip<double>& clip, LayeredValues& parameters) {
  const std::vector<HandPath> paths = player_.hand_paths(clip);
  for (std::size_t g = 0; g < parameters.swivels.size(); ++g) {
    const RolledOut played = player_.expand(clip, parameters);
    const ArmFeedback feedback =
        arm_feedback(*problem_, g, paths[g], played.motion.clip, hand_turn(*problem_, clip, g));
    SwivelSearch<double> search(player_.setup(), g);
    search.follow(paths[g], feedback.turn, &feedback);
    parameters.swivels[g] = search.fine();
  }
}

void LayeredScorer::score_finals(const ReducedClip<double>& clip,
                                 std::span<const LayeredValues> tried, std::span<double> scores) {
  if (!criteria_->user.empty()) {
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i] = judged(player_.expand(clip, tried[i]));
    }
    return;
  }
  Rows rows;
  for (const LayeredValues& parameters : tried) rows.add(parameters);
  const std::size_t weights = rows.arms.size() / scores.size();
  const auto keep = [&](std::span<const Vec3d>) {
    return std::vector<float>(rows.arms.begin(),
                              rows.arms.begin() + static_cast<std::ptrdiff_t>(weights));
  };
  LayeredInputs inputs = rows.inputs();
  inputs.idle = true;
  batch_.score(inputs, keep, scores, {});
}

void LayeredScorer::settle_rest(const ReducedClip<double>& clip, std::uint64_t seed,
                                LayeredValues& parameters) {
  const std::size_t angles = parameters.finals.size();
  const RestEvaluation score = [&](std::span<const double> finals, std::span<double> scores) {
    std::vector<LayeredValues> tried(scores.size(), parameters);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const auto first = finals.subspan(i * angles, angles);
      tried[i].finals.assign(first.begin(), first.end());
    }
    score_finals(clip, tried, scores);
  };
  search_finals(problem_->layers, seed, score, parameters.finals);
}

}  // namespace shigusa
