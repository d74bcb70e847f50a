// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <shigusa/hierarchy/generator.hpp>
#include <shigusa/rollout/batch_rollout.hpp>
#include <shigusa/rollout/detour.hpp>
#include <shigusa/rollout/reachability.hpp>
#include <utility>

namespace shigusa {
namespace {

// Steps of IK that each frame may take more where the goal is out of reach: stretched limbs turn
// fast and would jolt into the last frame.
constexpr int kEdgeCorrections = 3;

// Ways to the goals, tried in this order until one leads there: a straight hand path; the same with
// the null space drawn to a posture that is known to arrive; that posture alone.
std::vector<ReachProblem> ways_to_goal(ReachProblem problem, const ClosestReach& reach) {
  if (reach.reached()) add_detours(problem);
  ReachProblem guided = problem;
  guided.guide = reach.angles;
  ReachProblem posture = guided;
  posture.follow_path = false;
  if (reach.reached()) return {problem, guided, posture};
  // the edge of reach: the path ends at the closest point, and a hand whose limb is stretched out
  // lags behind a path that it need not keep
  guided.tolerance = posture.tolerance = {kEdgeTolerance, std::numeric_limits<double>::infinity()};
  guided.corrections = posture.corrections = kEdgeCorrections;
  for (std::size_t g = 0; g < problem.goals.size(); ++g) {
    guided.goals[g].path.goal = posture.goals[g].path.goal = reach.positions[g];
  }
  return {guided, posture};
}

// The score in double of what was searched in single precision.
double replayed_score(const ReachProblem& problem, const Task& task, const Parameters& parameters) {
  const RolledOut rolled = roll_out(problem, parameters);
  return rolled.outcome.met(problem.tolerance)
             ? score_motion(*problem.body, rolled.motion, task_criteria(task)).total
             : worst_score(task.criteria);
}

// The paper's weights at a point of the search's unit cube.
Parameters decode_point(std::span<const double> point) {
  return decode_paper_genes(genome_of_point(point, kPaperBitsPerGene));
}

// Scores points with criteria of the user's own, which want whole motions: one after the other.
void evaluate_one_by_one(const ReachProblem& problem, const Task& task,
                         std::span<const double> points, std::span<double> scores) {
  const std::size_t genes = problem.body->dofs().size();
  for (std::size_t i = 0; i < scores.size(); ++i) {
    scores[i] = replayed_score(problem, task, decode_point(points.subspan(i * genes, genes)));
  }
}

SearchResult search_weights(const ReachProblem& problem, const Task& task,
                            const Progress& progress) {
  SearchProblem searched;
  searched.genes = problem.body->dof_count();
  const CriteriaSettings criteria = task_criteria(task);
  BatchRollout batch(problem, criteria, task.batch);
  searched.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    if (task.criteria.user.empty()) {
      batch.score(inverse_weights_of_genes(genome_of_point(points, kPaperBitsPerGene)), scores);
    } else {
      evaluate_one_by_one(problem, task, points, scores);
    }
  };
  if (!task.evaluations) return genetic_search(searched, task.genetic, progress);
  return restarted_genetic_search(searched, task.genetic, *task.evaluations, progress);
}

std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip) {
  std::vector<LimitExcess> result;
  for (int d = 0; d < body.dof_count(); ++d) {
    const auto k = static_cast<std::size_t>(d);
    double excess = 0.0;
    for (int f = 0; f < clip.frames; ++f) {
      const std::span<const double> angles = clip.frame(f);
      excess = max(excess, angles[k] - upper_limit(body, d, angles));
      excess = max(excess, body.dof(d).lower - angles[k]);
    }
    // less than a tenth of a degree is nothing that anyone sees
    if (excess > radians(0.1)) result.push_back({body.dof(d).name, excess});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const LimitExcess& a, const LimitExcess& b) { return a.excess > b.excess; });
  return result;
}

PathKind path_kind(const ReachProblem& problem, const EffectorPath& path) {
  if (!problem.follow_path) return PathKind::free;
  return path.detour == Vec3d{} ? PathKind::straight : PathKind::detour;
}

Candidate make_candidate(const Task& task, const ReachProblem& problem,
                         const Parameters& parameters, RolledOut rolled) {
  const BodyModel& body = task.body;
  Candidate candidate;
  candidate.parameters = parameters;
  candidate.score = score_motion(body, rolled.motion, task_criteria(task));
  for (std::size_t g = 0; g < task.goals.size(); ++g) {
    const auto index = static_cast<std::size_t>(problem.goals[g].effector);
    const Effector& effector = body.effectors()[index];
    const Vec3d reached = rolled.motion.effectors[g].back();
    const Vec3d goal = task.goals[g].position;
    candidate.goals.push_back({effector.name, effector.node, goal, reached, norm(goal - reached),
                               path_kind(problem, problem.goals[g].path)});
  }
  candidate.path_error = rolled.outcome.path_error;
  for (const Foot& foot : body.feet()) {
    // the base cannot move; what another foot does was measured in every frame
    const double slide = foot.link == kBaseLink ? 0.0 : rolled.outcome.contact_slide;
    candidate.contacts.push_back({foot.name, foot.node, slide});
  }
  candidate.over_limit = limit_excess(body, rolled.motion.clip);
  candidate.motion = std::move(rolled.motion);
  return candidate;
}

// Orders scores, a NaN last.
double ranking(const Score& score) {
  return is_finite(score.total) ? score.total : std::numeric_limits<double>::infinity();
}

// Largest root-mean-square difference of two motions' joint angles over their frames (rad).
double posture_distance(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (int f = 0; f < a.frames; ++f) {
    double squares = 0.0;
    for (int d = 0; d < a.dofs; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double difference = a.frame(f)[k] - b.frame(f)[k];
      squares += difference * difference;
    }
    largest = max(largest, squares / a.dofs);
  }
  return sqrt(largest);
}

// At the edge of reach limbs are stretched, and some weights bring them there with a jolt: a change
// of a joint's step by more than this (rad) from one of kMotionSteps frames to the next. Minimum
// jerk over a range of 4 rad has a fifth of it.
constexpr double kJolt = radians(2.0);

bool jolts(const Clip& clip) {
  for (int f = 2; f < clip.frames; ++f) {
    for (int d = 0; d < clip.dofs; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double change = clip.frame(f)[k] - 2.0 * clip.frame(f - 1)[k] + clip.frame(f - 2)[k];
      if (abs(change) > kJolt) return true;
    }
  }
  return false;
}

// The motion does what its way asks for; beyond reach, without a jolt.
bool arrives(const ReachProblem& way, const RolledOut& rolled) {
  if (!rolled.outcome.met(way.tolerance)) return false;
  return way.tolerance.goal <= kReachTolerance || !jolts(rolled.motion.clip);
}

struct Arrival {
  const ReachProblem* way = nullptr;
  RolledOut rolled;
};

// The parameters' motion on the first way that brings them to the goal: the same parameters always
// give the same motion, whichever way they were found on.
std::optional<Arrival> first_arrival(std::span<const ReachProblem> ways,
                                     const Parameters& parameters) {
  for (const ReachProblem& way : ways) {
    RolledOut rolled = roll_out(way, parameters);
    if (arrives(way, rolled)) return Arrival{&way, std::move(rolled)};
  }
  return std::nullopt;
}

// Re-plays the final genomes and keeps those that arrive and differ, best first.
void collect_candidates(const Task& task, std::span<const ReachProblem> ways,
                        const SearchResult& found, Generation& generation) {
  std::vector<Individual> ranked;
  std::set<std::vector<double>> known;
  for (const Individual& individual : found.final_population) {
    if (known.insert(individual.point).second) ranked.push_back(individual);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Individual& a, const Individual& b) { return a.score < b.score; });
  for (const Individual& individual : ranked) {
    if (static_cast<int>(generation.candidates.size()) >= task.candidates) break;
    const Parameters parameters = decode_point(individual.point);
    std::optional<Arrival> arrival = first_arrival(ways, parameters);
    if (!arrival) {
      ++generation.missed;
      continue;
    }
    const auto is_copy = [&](const Candidate& better) {
      return posture_distance(better.motion.clip, arrival->rolled.motion.clip) < kDistinctPosture;
    };
    if (std::any_of(generation.candidates.begin(), generation.candidates.end(), is_copy)) {
      ++generation.near_copies;
      continue;
    }
    generation.candidates.push_back(
        make_candidate(task, *arrival->way, parameters, std::move(arrival->rolled)));
    if (arrival->way != &ways.back()) continue;
    // it was searched on this way, in single precision
    const double difference = abs(generation.candidates.back().score.total - individual.score);
    if (difference > kReplayTolerance) ++generation.replay_differs;
    generation.replay_difference = max(generation.replay_difference, difference);
  }
  // on an earlier way than they were searched on, motions may have other scores
  std::stable_sort(
      generation.candidates.begin(), generation.candidates.end(),
      [](const Candidate& a, const Candidate& b) { return ranking(a.score) < ranking(b.score); });
}

double miss_of(const Candidate& candidate) {
  double squares = 0.0;
  for (const GoalResult& goal : candidate.goals) squares += goal.error * goal.error;
  return sqrt(squares);
}

// The parameters' motion on the first way that brings them to the goal; where none does, the one
// that comes nearest, but rather one that is farther off than one whose foot slides.
Candidate only_candidate(const Task& task, std::span<const ReachProblem> ways,
                         const Parameters& parameters) {
  if (std::optional<Arrival> arrival = first_arrival(ways, parameters)) {
    return make_candidate(task, *arrival->way, parameters, std::move(arrival->rolled));
  }
  std::optional<Candidate> best;
  bool best_stands = false;
  for (const ReachProblem& way : ways) {
    RolledOut rolled = roll_out(way, parameters);
    const bool stands = rolled.outcome.stands();
    Candidate candidate = make_candidate(task, way, parameters, std::move(rolled));
    const bool nearer = best && miss_of(candidate) < miss_of(*best);
    if (!best || (stands == best_stands ? nearer : stands)) {
      best = std::move(candidate);
      best_stands = stands;
    }
  }
  return std::move(*best);
}

void finish(const ClosestReach& reach, Generation& generation) {
  const double miss = miss_of(generation.candidates.front());
  const bool met = reach.reached() && miss <= kReachTolerance;
  generation.status = met ? ReachStatus::reached : ReachStatus::unreachable;
  generation.remaining_distance = met ? 0.0 : miss;
}

Result<void> check_parameters(const BodyModel& body, const Parameters& parameters) {
  if (parameters.joints.size() != body.dofs().size()) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} joint weights for a body of {} dof", parameters.joints.size(),
                            body.dof_count()));
  }
  for (std::size_t d = 0; d < parameters.joints.size(); ++d) {
    const double weight = parameters.joints[d].weight;
    if (weight >= kWeightMin && weight <= kWeightMax) continue;
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("weight is {}; allowed are {:g} to {:g}", weight, kWeightMin, kWeightMax),
        body.dofs()[d].name);
  }
  return {};
}

}  // namespace

Result<Generation> generate(const Task& task, const Progress& progress) {
  const Result<ReachProblem> problem = make_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  const ClosestReach reach = closest_reach(*problem);
  const std::vector<ReachProblem> ways = ways_to_goal(*problem, reach);
  Generation generation;
  generation.duration = problem->duration;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const SearchResult found = search_weights(ways[w], task, progress);
    generation.evaluations += found.evaluations;
    generation.generations = found.generations;
    generation.rejected_nan += found.rejected_nan;
    generation.end = found.end;
    generation.best_seen = decode_point(found.best_seen.point);
    generation.best_seen_score = replayed_score(ways[w], task, *generation.best_seen);
    generation.missed = generation.replay_differs = 0;
    generation.replay_difference = 0.0;
    collect_candidates(task, std::span(ways).first(w + 1), found, generation);
    if (!generation.candidates.empty() || found.end == SearchEnd::cancelled) break;
  }
  if (generation.candidates.empty()) {
    generation.candidates.push_back(only_candidate(task, ways, uniform_parameters(task.body)));
  }
  finish(reach, generation);
  return generation;
}

Result<Generation> regenerate(const Task& task, const Parameters& parameters) {
  const Result<ReachProblem> problem = make_problem(task);
  if (!problem) return tl::unexpected(problem.error());
  if (const auto checked = check_parameters(task.body, parameters); !checked) {
    return tl::unexpected(checked.error());
  }
  const ClosestReach reach = closest_reach(*problem);
  const std::vector<ReachProblem> ways = ways_to_goal(*problem, reach);
  Generation generation;
  generation.duration = problem->duration;
  generation.candidates.push_back(only_candidate(task, ways, parameters));
  finish(reach, generation);
  return generation;
}

}  // namespace shigusa
