// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "approaches.hpp"
#include "candidate.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "generate/known_starts.hpp"
#include "planner.hpp"
#include "problem/rise.hpp"
#include "problem/task_goals.hpp"
#include "problem/task_supports.hpp"
#include "rollout/smooth_motion.hpp"
#include "whole_body_search.hpp"

namespace shigusa {
namespace {

// Archived postures considered per requested candidate.
constexpr int kKeptPerCandidate = 4;

Result<void> check_fixed(const Problem& problem) {
  const Task& task = problem.task;
  if (!task.fixed) return {};
  SHG_TRY(problem.parameters->check(task.fixed->values));
  if (task.fixed->set.size() != problem.parameters->size()) {
    return fail(ErrorCode::invalid_argument, say("fixed_of_another"));
  }
  const ParameterSpace space(problem.reach, *problem.parameters, gene_code(task), task.fixed);
  if (space.genes() > 0) return {};
  return fail(ErrorCode::invalid_argument, say("all_fixed"));
}

Result<void> check_starts(const Problem& problem) {
  const Task& task = problem.task;
  for (std::size_t k = 0; k < task.starts.size(); ++k) {
    const Result<void> good = problem.parameters->check(task.starts[k]);
    if (good) continue;
    const Error& error = good.error();
    const std::string place = fmt::format("starts[{}]", k);
    return fail(error.code, error.message,
                error.place.empty() ? place : place + ": " + error.place);
  }
  return {};
}

bool goes_around(const ReachProblem& problem) {
  return std::any_of(problem.goals.begin(), problem.goals.end(),
                     [](const ReachGoal& goal) { return goal.path.detour != Vec3d{}; });
}

// The best score of the known start points of a search, or of bent ones where none are known.
double best_start(const Problem& problem, const ReachProblem& approach) {
  const Task& task = problem.task;
  const ParameterSpace space(approach, *problem.parameters, gene_code(task), task.fixed);
  std::vector<double> points = KnownStarts(approach, space).points(task.starts);
  if (points.empty()) points = bent_starts(space);
  std::vector<double> scores(points.size() / index(std::max(space.genes(), 1)));
  PointScorer(problem, approach, problem.task.criteria, space, task.batch.threads)
      .score(points, scores);
  double best = worst_score(problem.task.criteria);
  for (const double score : scores) best = score < best ? score : best;
  return best;
}

// Whether motions may be scored before a search: by built-in criteria, with valid values.
bool may_score(const Problem& problem) {
  const Task& task = problem.task;
  return traits_of(task.preset).natural && !task.own_search &&
         !scores_whole_motions(task, task.criteria) && check_values(problem);
}

// The straight approach is searched if its score is below this share of the detour's, and one that
// stands up below this share of the usual one's: who can stand does.
constexpr double kStraightShare = 0.9;
constexpr double kRisingShare = 2.0;

// In rising the knees lead the hips, and the hips the back (Burgess-Limerick et al., Hum. Factors
// 37 (1995) 395): haste of the ways of the hips and the neck, and distance (statures) by which the
// hips go back before they go up, at that share of their time.
constexpr double kHipsHaste = 0.3;
constexpr double kNeckHaste = -0.1;
constexpr double kHipsBack = 0.023;
constexpr double kHipsBackAt = 0.3;

// The problem with a point of the body led to where it is in standing; no goal of the task. False
// if the body has no such effector, or the IK no rows left.
bool lead(HumanoidBone bone, double haste, ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  const auto index = body.find_effector(humanoid_bone_name(bone));
  const auto has = [&index](const ReachGoal& goal) { return goal.effector == *index; };
  if (!index || std::any_of(problem.goals.begin(), problem.goals.end(), has)) return false;
  const Effector& effector = body.effector(*index);
  ReachGoal& way = problem.goals.emplace_back();
  way.effector = *index;
  way.path.start = placed(body, problem.start()).point(effector.link, effector.point);
  way.path.goal = placed(body, problem.standing()).point(effector.link, effector.point);
  way.path.haste = haste;
  ++problem.led;
  return check_rows(problem).has_value();
}

// Brings the hips' way off its line, back from where the standing pelvis faces.
void go_back_first(ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  ReachGoal& hips = problem.goals.back();
  const int pelvis = body.effector(hips.effector).link;
  const Vec3d ahead = placed(body, problem.standing()).link_rotation(pelvis).cz;
  hips.path.detour =
      normalized(Vec3d{ahead.x, 0.0, ahead.z}, {0, 0, 1}) * (-kHipsBack * body.stature());
  hips.path.detour_peak = kHipsBackAt;
}

// Turns the hips upright, as in standing, on their way: beneath an arm that reaches up they would
// tip and bend the knees. False if the IK has no rows left.
bool level_hips(ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  ReachGoal& hips = problem.goals.back();
  const int pelvis = body.effector(hips.effector).link;
  hips.turn = {.kind = Turning::axis,
               .start = placed(body, problem.start()).link_rotation(pelvis),
               .goal = {},
               .axis = {0, 1, 0},
               .direction = placed(body, problem.standing()).link_rotation(pelvis).cy};
  return check_rows(problem).has_value();
}

// Brings the neck's way off its line, so that it keeps its distance from the hips, which are led
// before it.
void go_about_hips(ReachProblem& problem) {
  const EffectorPath& hips = problem.goals[problem.goals.size() - 2].path;
  EffectorPath& neck = problem.goals.back().path;
  const Vec3d first = neck.start - hips.start;
  const Vec3d last = neck.goal - hips.goal;
  const Vec3d half = normalized(normalized(first) + normalized(last)) * norm(first);
  neck.detour = hips.at(0.5) + half - neck.at(0.5);
  neck.detour_peak = neck.own_time(0.5);
}

// A way up that is there is found soon.
constexpr ReachabilitySettings kRisingReach{.starts = 4, .iterations = 100};

// The problems of a person who begins bent and stands up: the hips alone, with the neck, or turned
// upright go up on ways of their own. None where the user fixes knees that no standing person has.
std::vector<ReachProblem> ways_up(const Problem& problem, const ReachProblem& reach) {
  const bool keeps_bent = fixed_value(problem, "squat_rad").value_or(0.0) > kStandsKnees;
  ReachProblem hips = reach;
  if (reach.rise.empty() || keeps_bent || !lead(HumanoidBone::hips, kHipsHaste, hips)) return {};
  go_back_first(hips);
  std::vector<ReachProblem> ways{hips};
  ReachProblem trunk = hips;
  if (lead(HumanoidBone::neck, kNeckHaste, trunk)) {
    go_about_hips(trunk);
    ways.push_back(std::move(trunk));
  }
  if (level_hips(hips)) ways.push_back(std::move(hips));
  return ways;
}

// A way to the goals by its number (Problem::way), and the approaches on it: with a detour where
// one is needed, straight, or standing up in one of `ways_up`.
constexpr int kAround = 0;
constexpr int kStraight = 1;
constexpr int kUp = 2;
struct Way {
  int number = kAround;
  std::vector<ReachProblem> approaches{};
};

// None where the way does not lead to the goals.
std::vector<ReachProblem> approaches_up(const ReachProblem& up) {
  const ClosestReach there = closest_reach(up, kRisingReach);
  if (!there.reached()) return {};
  return approaches_to_goal(up, there, true);
}

// None of a way that is not there.
std::vector<ReachProblem> approaches_by(int way, const Problem& problem, const ReachProblem& reach,
                                        const ClosestReach& closest) {
  if (way < kAround) return {};
  if (way < kUp) return approaches_to_goal(reach, closest, way == kStraight);
  const std::vector<ReachProblem> ways = ways_up(problem, reach);
  const std::size_t up = index(way - kUp);
  return up < ways.size() ? approaches_up(ways[up]) : std::vector<ReachProblem>{};
}

// The way of a problem, as the planner of its task without a duration finds it.
int way_in_usual_time(const Problem& problem) {
  const auto usual = with_duration(problem, std::nullopt);
  if (!usual || !make_whole_body_planner(**usual)) return kAround;
  return (*usual)->way;
}

// The way whose start points score best. The need of a detour is found with uniform weights, so the
// best motions from the start table may do without.
Way best_way(const Problem& problem, const ReachProblem& reach, const ClosestReach& closest) {
  Way best{kAround, approaches_to_goal(reach, closest)};
  const bool detours = goes_around(best.approaches.front());
  const std::vector<ReachProblem> ups = ways_up(problem, reach);
  if (!may_score(problem) || (ups.empty() && !detours)) return best;
  if (problem.task.duration) {
    const int usual = way_in_usual_time(problem);
    std::vector<ReachProblem> approaches = approaches_by(usual, problem, reach, closest);
    return approaches.empty() ? best : Way{usual, std::move(approaches)};
  }
  double least = best_start(problem, best.approaches.front());
  const auto offer = [&](int number, std::vector<ReachProblem> approaches, double most) {
    if (approaches.empty()) return;
    const double start = best_start(problem, approaches.front());
    if (!(start < most)) return;
    best = {number, std::move(approaches)};
    least = start;
  };
  if (detours) {
    offer(kStraight, approaches_to_goal(reach, closest, true), kStraightShare * least);
  }
  least *= kRisingShare;
  for (std::size_t k = 0; k < ups.size(); ++k) {
    offer(kUp + static_cast<int>(k), approaches_up(ups[k]), least);
  }
  return best;
}

class WholeBodyPlanner : public Planner {
 public:
  // `settled`: with the places on which hands rest.
  WholeBodyPlanner(const Problem& problem, ReachProblem settled)
      : problem_(problem), task_(problem.task), reach_(std::move(settled)) {
    ClosestReach closest = closest_reach(reach_);
    in_reach_ = closest.reached();
    if (!in_reach_ && traits_of(task_.preset).natural) {
      // people stop before a hand enters their own body
      reach_ = clear_goals(reach_, closest);
      closest = closest_reach(reach_);
    }
    usual_approaches_ = approaches_by(problem_.way, problem_, reach_, closest);
    if (usual_approaches_.empty()) {
      Way way = best_way(problem_, reach_, closest);
      problem_.way = way.number;
      usual_approaches_ = std::move(way.approaches);
    }
    approaches_ = usual_approaches_;
  }

  [[nodiscard]] bool in_reach() const override { return in_reach_; }
  [[nodiscard]] std::size_t approaches() const override { return approaches_.size(); }

  bool go_by_other_posture(int other) override {
    if (other == 0) {
      approaches_ = usual_approaches_;
      return true;
    }
    const ClosestReach closest = closest_reach(reach_, {.other = other});
    if (!closest.reached()) return false;
    approaches_ = approaches_to_goal(reach_, closest);
    return true;
  }

  Found search(const RunSettings& run, std::size_t number, const Progress& progress) override {
    const ReachProblem& approach = approaches_[number];
    WholeBodySearch searched(problem_, approach, run);
    Found found{.result = searched.run(progress), .selection = {}, .best_seen = {}};
    space_ = searched.space();
    found.selection =
        traits_of(task_.preset).natural
            ? distinct_postures(searched.archive(), kKeptPerCandidate * task_.candidates)
            : Selection{.picked = ranked_population(found.result)};
    if (wants_one(task_)) return found;
    found.best_seen = space_->decode(found.result.best_seen.point);
    found.best_seen_score = replayed_score(approach, *found.best_seen);
    return found;
  }

  Expanded expand(std::span<const double> point) override {
    return {.values = space_->decode(point)};
  }

  [[nodiscard]] std::optional<Arrival> arrival(const Parameters& values,
                                               std::size_t last) const override {
    auto arrival = first_arrival(std::span(approaches_).first(last + 1), values, task_.generator);
    if (arrival) arrival->as_searched = arrival->approach == &approaches_[last];
    return arrival;
  }

  [[nodiscard]] Arrival nearest(const Parameters& values) const override {
    return nearest_arrival(approaches_, values, task_.generator);
  }

  [[nodiscard]] Candidate candidate(const Expanded& expanded, Arrival arrival) const override {
    const ReachProblem& approach = *arrival.approach;
    const bool smooths = approach.smooth && task_.generator == MotionGenerator::weighted_ik;
    RolledOut rolled = smooths ? smoothed(approach, expanded.values, std::move(arrival.rolled))
                               : std::move(arrival.rolled);
    Candidate made = make_candidate(problem_, approach, expanded.values, std::move(rolled));
    made.approach = problem_.way;
    return made;
  }

  void finish(GenerateResult& /*generation*/) override {}

 private:
  // The score in double precision of values searched in single precision.
  [[nodiscard]] double replayed_score(const ReachProblem& approach,
                                      const Parameters& values) const {
    const RolledOut rolled = play(approach, values, task_.generator);
    return rolled.outcome.met(approach.tolerance)
               ? score_motion(task_.body, rolled.motion, task_.criteria, approach.context).total
               : worst_score(problem_.task.criteria);
  }

  const Problem& problem_;
  const Task& task_;    // the problem's
  ReachProblem reach_;  // with the resting places of hands; natural goals are clear of the body
  bool in_reach_ = false;
  std::vector<ReachProblem> usual_approaches_;
  std::vector<ReachProblem> approaches_;
  std::optional<ParameterSpace> space_;  // of the last search
};

}  // namespace

Result<std::unique_ptr<Planner>> make_whole_body_planner(const Problem& problem) {
  ReachProblem settled = problem.reach;
  SHG_TRY(settle_supports(problem.task, settled));
  return std::make_unique<WholeBodyPlanner>(problem, std::move(settled));
}

Result<std::unique_ptr<Planner>> make_planner(const Problem& problem) {
  if (traits_of(problem.task.preset).layers) return make_layered_planner(problem);
  return make_whole_body_planner(problem);
}

Result<void> check_values(const Problem& problem) {
  const Task& task = problem.task;
  if (!traits_of(task.preset).layers) {
    SHG_TRY(check_starts(problem));
    return check_fixed(problem);
  }
  if (!task.fixed) return {};
  return fail(ErrorCode::invalid_argument, say("fixed_elsewhere", word_of(task.preset)));
}

}  // namespace shigusa
