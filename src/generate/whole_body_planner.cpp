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

// The best score of the start points of a search.
double best_start(const Problem& problem, const ReachProblem& approach) {
  const Task& task = problem.task;
  const ParameterSpace space(approach, *problem.parameters, gene_code(task), task.fixed);
  std::vector<double> points = KnownStarts(approach, space).points(task.starts);
  const std::vector<double> bent = bent_starts(space);
  points.insert(points.end(), bent.begin(), bent.end());
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

// The approaches with a detour where one is needed: the need is found with uniform weights, so the
// best motions from the start table may do without.
std::vector<ReachProblem> usual_approaches(const Problem& problem, const ReachProblem& there,
                                           const ClosestReach& reach) {
  std::vector<ReachProblem> around = approaches_to_goal(there, reach);
  if (!goes_around(around.front()) || !may_score(problem)) return around;
  std::vector<ReachProblem> straight = approaches_to_goal(there, reach, true);
  const bool does_without =
      best_start(problem, straight.front()) < kStraightShare * best_start(problem, around.front());
  return does_without ? straight : around;
}

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

// The approaches of a person who begins bent and stands up, and their best start: the hips alone,
// with the neck, or turned upright go up on ways of their own. No approaches where the goals cannot
// be met like that, or where the user fixes knees that no standing person has.
// A way up that is there is found soon.
constexpr ReachabilitySettings kRisingReach{.starts = 4, .iterations = 100};
struct Rising {
  double start = std::numeric_limits<double>::infinity();
  std::vector<ReachProblem> approaches{};
};
Rising rising(const Problem& problem, const ReachProblem& reach) {
  Rising best;
  const bool keeps_bent = fixed_value(problem, "squat_rad").value_or(0.0) > kStandsKnees;
  if (reach.rise.empty() || !may_score(problem) || keeps_bent) return best;
  ReachProblem hips = reach;
  if (!lead(HumanoidBone::hips, kHipsHaste, hips)) return best;
  go_back_first(hips);
  std::vector<ReachProblem> ways{hips};
  ReachProblem trunk = hips;
  if (lead(HumanoidBone::neck, kNeckHaste, trunk)) {
    go_about_hips(trunk);
    ways.push_back(std::move(trunk));
  }
  if (level_hips(hips)) ways.push_back(std::move(hips));
  for (const ReachProblem& up : ways) {
    const ClosestReach closest = closest_reach(up, kRisingReach);
    if (!closest.reached()) continue;
    std::vector<ReachProblem> approaches = approaches_to_goal(up, closest, true);
    const double start = best_start(problem, approaches.front());
    if (start < best.start) best = {start, std::move(approaches)};
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
    usual_approaches_ = usual_approaches(problem_, reach_, closest);
    if (Rising up = rising(problem_, reach_); !up.approaches.empty()) {
      const double usual = best_start(problem_, usual_approaches_.front());
      if (up.start < kRisingShare * usual) usual_approaches_ = std::move(up.approaches);
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
    found.best_seen = space_->decode(found.result.best_seen.point);
    found.best_seen_score = replayed_score(approach, found.best_seen);
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
    return make_candidate(problem_, approach, expanded.values, std::move(rolled));
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
