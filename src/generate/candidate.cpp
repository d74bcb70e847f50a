// SPDX-License-Identifier: MIT
#include "candidate.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "distinct.hpp"
#include "generate/posture_meter.hpp"
#include "problem/task_goals.hpp"

namespace shigusa {

namespace {

// Whether the parameter values bend the paths away from straight lines.
bool bends_paths(const ParameterList& list, const Parameters& values) {
  const std::vector<double> numbers = list.of_kind(ParameterKind::timing, values);
  Timing<double> timing;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    timing.*kTimingMembers<double>[k] = numbers[k];
  }
  return timing.bends_paths();
}

PathKind path_kind(const ReachProblem& problem, const EffectorPath& path, bool bends) {
  if (!problem.follow_path) return PathKind::free;
  if (path.detour != Vec3d{}) return PathKind::detour;
  return bends ? PathKind::bowed : PathKind::straight;
}

// Adds the result of each of the task's goals, on any approach.
void add_goal_results(const Problem& of, const ReachProblem& problem, const Motion& motion,
                      Candidate& candidate) {
  const Task& task = of.task;
  const BodyModel& body = task.body;
  const bool bends = bends_paths(*of.parameters, candidate.parameters);
  const Clip& clip = motion.clip;
  Kinematics<double> start(body);
  Kinematics<double> end(body);
  forward_kinematics<double>(body, clip.frame(0), start);
  forward_kinematics<double>(body, clip.frame(clip.frames - 1), end);
  for (std::size_t g = 0; g < task.goals.size(); ++g) {
    const Goal& asked = task.goals[g];
    const ReachGoal& reach = problem.goals[g];
    const Effector& effector = body.effector(reach.effector);
    const Vec3d reached = motion.effectors[g].back();
    GoalResult& result = candidate.goals.emplace_back();
    result.asked = asked;
    result.node = effector.node;
    result.reached = reached;
    result.error = goal_miss(asked, reached);
    result.path = path_kind(problem, reach.path, bends);
    const EffectorTurn turn = goal_turn(body, asked, reach.effector, start);
    result.turn.start = to_quat(start.link_rotation(effector.link));
    result.turn.reached = to_quat(end.link_rotation(effector.link));
    if (turn.kind != Turning::free) {
      result.turn.error = turn.miss(end.link_rotation(effector.link));
    }
  }
}

double frame_distance(const Clip& a, const Clip& b, int frame) {
  double squares = 0.0;
  for (int d = 0; d < a.dofs; ++d) {
    const auto k = static_cast<std::size_t>(d);
    const double difference = a.frame(frame)[k] - b.frame(frame)[k];
    squares += difference * difference;
  }
  return sqrt(squares / a.dofs);
}

// Largest slide (m) of a planted foot, or of a resting hand on its support, over the frames in
// which it is to stay. `link`: of the foot or hand.
double slide_of(const ReachProblem& problem, const Clip& clip, int link) {
  const std::vector<Constraint<double>> all = constraints(problem);
  const auto contact = std::find_if(all.begin(), all.end(), [&](const Constraint<double>& each) {
    return each.exact && each.link == link;
  });
  Kinematics<double> placed(*problem.body);
  double most = 0.0;
  for (int f = 0; f < clip.frames; ++f) {
    if (!contact->holds_at(static_cast<double>(f) / problem.steps)) continue;
    forward_kinematics<double>(*problem.body, clip.frame(f), placed);
    most = max(most, norm(position_error(placed, *contact)));
  }
  return most;
}

// Adds the results of the hands that rest in this motion.
void add_resting_hands(const Problem& of, const ReachProblem& problem, const Motion& motion,
                       Candidate& candidate) {
  const Task& task = of.task;
  const std::vector<double> presses =
      of.parameters->of_kind(ParameterKind::support, candidate.parameters);
  for (std::size_t k = 0; k < problem.supports.size(); ++k) {
    if (presses[k] < 0.0) continue;
    const Effector& hand = task.body.effector(problem.supports[k].effector);
    RestResult& rest = candidate.resting.emplace_back();
    rest.effector = hand.name;
    rest.node = hand.node;
    rest.on = task.supports[k].on;
    rest.max_slide = slide_of(problem, motion.clip, hand.link);
    for (const Vec3d& force : motion.resting[k].forces) rest.force = max(rest.force, norm(force));
  }
}

// The problem's circumstances, without the resting places of hands that stay free.
CriteriaContext context_of(const Problem& problem, const Candidate& candidate) {
  const Task& task = problem.task;
  CriteriaContext context = problem.reach.context;
  std::erase_if(context.resting, [&](const RestingPlace& place) {
    return std::none_of(candidate.resting.begin(), candidate.resting.end(),
                        [&](const RestResult& rest) {
                          const int hand = task.body.find_effector(rest.effector).value();
                          return task.body.effector(hand).link == place.link;
                        });
  });
  return context;
}

// a NaN ranks below any score
double ranking(const Score& score) {
  return is_finite(score.total) ? score.total : std::numeric_limits<double>::infinity();
}

// Lift of the heel over a clip. `foot`: R_WL of the forefoot, which stays on the floor.
HeelLift heel_lift(const Heel& heel, const Clip& clip, const Mat3d& foot) {
  HeelLift lift;
  for (int f = 0; f < clip.frames; ++f) {
    const double angle = clip.frame(f)[static_cast<std::size_t>(heel.toes)];
    const SinCos<double> turn = sin_cos(angle);
    const double up = heel.back.y * (turn.cos - 1.0) - heel.back.z * turn.sin;
    const double ahead = heel.back.z * (turn.cos - 1.0) + heel.back.y * turn.sin;
    const double height = foot.cy.y * up + foot.cz.y * ahead;
    lift = {max(lift.angle, angle), max(lift.height, height)};
  }
  return lift;
}

}  // namespace

Candidate make_candidate(const Problem& problem, const ReachProblem& approach,
                         const Parameters& parameters, RolledOut rolled) {
  const Task& task = problem.task;
  const BodyModel& body = task.body;
  Candidate candidate;
  candidate.parameters = parameters;
  candidate.score = score_motion(body, rolled.motion, task.criteria, problem.reach.context);
  add_goal_results(problem, approach, rolled.motion, candidate);
  candidate.path_error = rolled.outcome.path_error;
  for (const Foot& foot : body.feet()) {
    // The base foot is fixed; the other foot's slide was measured during the rollout.
    const bool alone = approach.supports.empty();  // the rollout's slide includes resting hands
    const double slide = foot.link == kBaseLink ? 0.0
                         : alone                ? rolled.outcome.contact_slide
                                                : slide_of(approach, rolled.motion.clip, foot.link);
    candidate.contacts.push_back({foot.name, foot.node, slide, {}});
    if (!foot.heel) continue;
    const Mat3d stands = placed(body, task.start).link_rotation(foot.link);
    candidate.contacts.back().heel = heel_lift(*foot.heel, rolled.motion.clip, stands);
  }
  add_resting_hands(problem, approach, rolled.motion, candidate);
  candidate.measures = measure_motion(body, rolled.motion, context_of(problem, candidate));
  candidate.judgement = judge(body, candidate.measures);
  const Clip& clip = rolled.motion.clip;
  candidate.final_posture = PostureMeter(body, task.home, approach.goals.front().effector)
                                .measure(clip.frame(clip.frames - 1));
  candidate.motion = std::move(rolled.motion);
  return candidate;
}

double miss_of(const Candidate& candidate) {
  double squares = 0.0;
  for (const GoalResult& goal : candidate.goals) {
    squares += goal.error * goal.error;
    const double turn = kTurnLength * goal.turn.error.value_or(0.0);
    squares += turn * turn;
  }
  return sqrt(squares);
}

ReachStatus status_of(bool met, std::span<const Candidate> candidates) {
  if (!met) return ReachStatus::unreachable;
  const bool some = std::any_of(candidates.begin(), candidates.end(), could_be_made);
  return some ? ReachStatus::reached : ReachStatus::unsteady;
}

bool could_be_made(const Candidate& candidate) {
  return candidate.judgement.verdict != Verdict::impossible;
}

int shown_least(const Task& task) { return std::min(kShownLeast, task.candidates); }

bool wants_one(const Task& task) {
  const PresetTraits& traits = traits_of(task.preset);
  return task.candidates == 1 && !task.duration && traits.natural && !traits.layers;
}

bool collides(const Candidate& candidate) {
  return candidate.measures.collides.depth > kCollisionDepth;
}

bool RanksBefore::operator()(const Candidate& a, const Candidate& b) const {
  const auto key = [this](const Candidate& c) {
    return std::tuple(!could_be_made(c), asks_free && collides(c), ranking(c.score));
  };
  return key(a) < key(b);
}

RanksBefore ranks_of(const Task& task) {
  const PresetTraits& traits = traits_of(task.preset);
  return {traits.natural && !traits.layers && !task.pareto};
}

double largest_distance(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (int f = 0; f < a.frames; ++f) largest = max(largest, frame_distance(a, b, f));
  return largest;
}

double final_distance(const Clip& a, const Clip& b) { return frame_distance(a, b, a.frames - 1); }

void add_counts(const SearchResult& found, GenerateResult& generation) {
  generation.log.evaluations += found.evaluations;
  generation.log.generations = found.generations;
  generation.log.rejected_nan += found.rejected_nan;
  generation.end = found.end;
}

}  // namespace shigusa
