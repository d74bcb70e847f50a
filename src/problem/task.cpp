// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/request.hpp>
#include <utility>

#include "around_obstacles.hpp"
#include "body/load.hpp"
#include "core/say.hpp"
#include "criteria/built_in_criteria.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "math/axes.hpp"
#include "motion/minimum_jerk.hpp"
#include "problem/natural_times.hpp"
#include "problem/plan_of.hpp"
#include "problem/request_fields.hpp"
#include "rise.hpp"
#include "rollout/reach_problem.hpp"
#include "task_goals.hpp"
#include "task_supports.hpp"

namespace shigusa {
namespace {

Result<void> check_obstacle(const Obstacle& obstacle) {
  const auto wrong = [&obstacle](Message message) {
    return fail(ErrorCode::invalid_argument, std::move(message),
                "obstacle " + obstacle.name.substr(0, 80));
  };
  const auto range = Metres{kGoalRange};
  for (const int k : {0, 1, 2}) {
    const char axis = "xyz"[k];
    const auto at = Metres{obstacle.position[k]};
    const auto size = Metres{obstacle.size[k]};
    if (!(at.value >= -kGoalRange && at.value <= kGoalRange)) {
      return wrong(say("coordinate_range", axis, at, range, range));
    }
    if (!(size.value >= 0.0 && size.value <= kGoalRange)) {
      return wrong(say("obstacle_size", axis, size, range));
    }
  }
  if (!(obstacle.radius >= 0.0 && obstacle.radius <= kGoalRange)) {
    return wrong(say("obstacle_radius", Metres{obstacle.radius}, range));
  }
  const Quatd& q = obstacle.rotation;
  if (is_unit(q)) return {};
  return wrong(say("no_unit_quaternion", q.x, q.y, q.z, q.w, sqrt(squared_length(q))));
}

Result<void> check_obstacles(const Task& task) {
  if (task.obstacles.size() > kObstaclesMax) {
    return fail(ErrorCode::invalid_argument,
                say("obstacles_most", task.obstacles.size(), kObstaclesMax));
  }
  for (const Obstacle& obstacle : task.obstacles) {
    SHG_TRY(check_obstacle(obstacle));
  }
  return {};
}

// Fails if heels lift and the preset is not flat, the only one that supports it.
Result<void> check_heels(const Task& task) {
  const auto feet = task.body.feet();
  const bool lift =
      std::any_of(feet.begin(), feet.end(), [](const Foot& foot) { return foot.heel.has_value(); });
  if (!lift || task.preset == Preset::flat) return {};
  return fail(ErrorCode::invalid_argument, say("no_heels", word_of(task.preset)));
}

Result<void> check_fingers(const Task& task) {
  if (!task.body.is_robot() || task.finger_play == FingerPlay::grip) return {};
  return fail(ErrorCode::invalid_argument, say("robot_fingers", task.body.name()), "finger_play");
}

Result<void> check_phases(const Task& task) {
  if (task.phases == 1) return {};
  return fail(ErrorCode::unsupported, say("one_phase"), "phases");
}

Result<void> check_numbers(const Task& task) {
  if (task.duration &&
      !(*task.duration >= kTaskDurationMin && *task.duration <= kTaskDurationMax)) {
    return fail(ErrorCode::invalid_argument,
                say("duration_range", *task.duration, kTaskDurationMin, kTaskDurationMax));
  }
  if (task.evaluations && *task.evaluations < task.genetic.population) {
    return fail(ErrorCode::invalid_argument,
                say("evaluations_range", *task.evaluations, task.genetic.population));
  }
  if (task.candidates < 1) {
    return fail(ErrorCode::invalid_argument, say("candidates_range", task.candidates));
  }
  return {};
}

Result<void> check_habit(const Task& task) {
  Result<void> fine;
  for_each_field<Habit>([&](const auto& field) {
    const double number = task.habit.*field.member;
    const auto& [low, high] = std::pair(field.traits.low, field.traits.high);
    if (!fine || (number >= low && number <= high)) return;
    fine = fail(ErrorCode::invalid_argument, say("habit_range", field.key, number, low, high),
                "habit");
  });
  SHG_TRY(fine);
  const PresetTraits& preset = traits_of(task.preset);
  if (task.habit == Habit{} || preset.natural) return {};
  return fail(ErrorCode::invalid_argument, say("no_habit", preset.word), "habit");
}

Result<void> check_timing(const Task& task) {
  if (!(task.ease >= -kEaseMax && task.ease <= kEaseMax)) {
    return fail(ErrorCode::invalid_argument, say("ease_range", task.ease, -kEaseMax, kEaseMax));
  }
  if (!(task.gaze_lead >= kGazeLeadLeast && task.gaze_lead <= kGazeLeadMost)) {
    return fail(ErrorCode::invalid_argument,
                say("gaze_lead_range", task.gaze_lead, kGazeLeadLeast, kGazeLeadMost));
  }
  SHG_TRY(check_habit(task));
  const PresetTraits& preset = traits_of(task.preset);
  if (task.ease != 0.0 && preset.layers) {
    return fail(ErrorCode::invalid_argument, say("ease_of_layers", preset.word), "ease");
  }
  if (task.gaze_lead == 0.0 || preset.natural) return {};
  return fail(ErrorCode::invalid_argument, say("no_gaze_lead", preset.word), "gaze_lead");
}

Result<void> check_gaze(const Task& task) {
  if (!task.look_at || is_within(*task.look_at, kGoalRange)) return {};
  return fail(ErrorCode::invalid_argument,
              say("finite_numbers", Metres{kGoalRange}, Metres{kGoalRange}), "look_at");
}

Result<void> check_criteria(const CriteriaSettings& criteria) {
  double sum = 0.0;
  bool valid = true;
  bool scaled = true;
  const auto add = [&](double weight, double scale) {
    valid = is_finite(sum += weight) && weight >= 0.0 && valid;
    scaled = scaled && scale > 0.0;
  };
  for (const CriterionSetting& setting : criteria.built_in) add(setting.weight, setting.scale);
  for (const UserCriterion& user : criteria.user) add(user.weight, user.scale);
  if (!valid || sum <= 0.0) {
    return fail(ErrorCode::invalid_argument, say("no_weights"));
  }
  if (!scaled) {
    return fail(ErrorCode::invalid_argument, say("reference_scales"));
  }
  return {};
}

Result<void> check_settings(const Task& task) {
  SHG_TRY(check_start(task));
  SHG_TRY(check_numbers(task));
  SHG_TRY(check_timing(task));
  SHG_TRY(check_phases(task));
  SHG_TRY(check_heels(task));
  SHG_TRY(check_fingers(task));
  SHG_TRY(check_gaze(task));
  SHG_TRY(check_obstacles(task));
  return check_criteria(task.criteria);
}

// Lets a goal's effector go on from the velocity with which it starts.
void carry_on(const Kinematics<double>& start, double duration, const Task& task, ReachGoal& goal) {
  if (task.start.velocities.empty()) return;
  const Effector& effector = task.body.effector(goal.effector);
  const Vec3d at = start.point(effector.link, effector.point);
  for (const int d : task.body.chain(effector.link)) {
    const double turn = task.start.velocities[static_cast<std::size_t>(d)] * duration;
    goal.path.momentum += position_column(start, d, at) * turn;
    goal.spin += start.axis[static_cast<std::size_t>(d)] * turn;
  }
}

// Leads a path through a place, at the time by which it has made the place's share of the way.
void pass_by(const Vec3d& place, EffectorPath& path) {
  constexpr double kNearEnd = 0.1;  // chosen: no sooner after the start or before the end
  constexpr int kHalvings = 40;
  const double before = norm(place - path.start);
  const double whole = before + norm(path.goal - place);
  if (!(whole > 0.0)) return;
  double low = kNearEnd;
  double high = 1.0 - kNearEnd;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (minimum_jerk(middle) * whole < before ? low : high) = middle;
  }
  path.detour_peak = 0.5 * (low + high);
  path.detour = place - (path.start + (path.goal - path.start) * minimum_jerk(path.detour_peak));
}

// The way of the thing in the hands around the obstacles; `start`: the body at the start.
EffectorPath way_around(const Task& task, const Kinematics<double>& start, const Carry& carry) {
  std::vector<Vec3d> corners;
  for (const HeldLoad& load : task.start.held) {
    const Mat3d axes =
        start.link_rotation(task.body.effector(load.effector).link) * to_matrix(load.turn);
    for (const HeldPart& part : load.parts) {
      const Vec3d half = part.size * 0.5 + Vec3d{part.radius, part.radius, part.radius};
      for (const double x : {-half.x, half.x}) {
        for (const double y : {-half.y, half.y}) {
          for (const double z : {-half.z, half.z}) {
            corners.push_back(axes * (part.offset + Vec3d{x, y, z}));
          }
        }
      }
    }
  }
  EffectorPath way{.start = carry.from, .goal = carry.to};
  carry_around_obstacles(criteria_context(task), corners, way);
  return way;
}

// Corrections in a frame whose effector has left its path by more than kPathSlack, as limits hold
// joints back.
constexpr int kLimitCorrections = 2;
constexpr double kPathSlack = 3e-4;  // m

// Factor on the number of motions for a task with supports.
constexpr int kTimesOfSupports = 3;

}  // namespace

int usual_evaluations(const Task& task) {
  if (task.generator == MotionGenerator::nlp_ik) return kNlpEvaluations;
  // an arm that takes part has weights of its own, and fewer motions keep its hand in place
  const int times = task.supports.empty() ? 1 : kTimesOfSupports;
  return times * traits_of(task.preset).evaluations;
}

SearchMethod search_of(const Task& task) {
  return task.search.value_or(traits_of(task.preset).search);
}

void adopt_habit(Request& request, const Habit& habit) {
  const auto own = [](const Habit& of) { return of.knees != Habit{}.knees; };
  double& weight = request.criteria[CriterionKind::coordination].weight;
  if (own(habit) && !own(request.habit)) weight *= kOwnKneesWeigh;
  if (!own(habit) && own(request.habit)) weight /= kOwnKneesWeigh;
  request.habit = habit;
}

// Sets a preset's own criteria and number of candidates.
static void take_defaults(Request& request, Preset preset) {
  request.preset = preset;
  request.criteria = traits_of(preset).criteria();
  request.candidates = traits_of(preset).candidates;
  adopt_habit(request, std::exchange(request.habit, {}));
}

void adopt_preset(Request& request, const Preset& preset) {
  if (preset != request.preset) take_defaults(request, preset);
}

void adopt_pareto(Request& request, const bool& pareto) {
  if (pareto && !request.pareto) request.criteria = pareto_criteria();
  request.pareto = pareto;
}

Task with_preset(Task task, Preset preset) {
  take_defaults(task, preset);
  return task;
}

CriteriaContext criteria_context(const Task& task) {
  CriteriaContext context{.start = task.start,
                          .gaze = task.look_at,
                          .obstacles = task.obstacles,
                          .resting = resting_places(task),
                          .habit = task.habit};
  if (!context.gaze) context.gaze = gaze_of(task.body, task.goals);
  for (const Goal& goal : task.goals) {
    if (const auto effector = task.body.find_effector(goal.effector)) {
      context.effectors.push_back(*effector);
    }
  }
  return context;
}

Result<ReachProblem> make_problem(const Task& task) {
  if (task.goals.empty()) {
    return fail(ErrorCode::invalid_argument, say("no_goal"));
  }
  SHG_TRY(check_settings(task));
  const BodyModel& body = task.body;
  const Kinematics<double> kinematics = placed(body, task.start);
  const bool natural = traits_of(task.preset).natural;
  ReachProblem problem;
  problem.body = &body;
  problem.context = criteria_context(task);
  problem.home = task.home;
  if (natural && task.start.velocities.empty()) problem.rise = rise_of(body, problem.context);
  problem.duration = 0.0;
  std::vector<double> owns;  // (goals) s, duration of each alone
  for (const Goal& goal : task.goals) {
    SHG_TRY_ASSIGN(ReachGoal reach, make_reach_goal(body, kinematics, goal));
    const bool hand = body.effector(reach.effector).part.limb == LimbKind::arm;
    if (hand && natural && task.start.velocities.empty()) {
      // a thing leaves at once, with all hands on it
      const EffectorPath way =
          reach.carry ? EffectorPath{reach.carry->start, reach.carry->goal} : reach.path;
      reach.path.begin = reach.carry ? 0.0 : natural_begin(way);
      reach.path.haste = natural_haste(way);
      if (goal.via) {
        pass_by(*goal.via, reach.path);
        reach.bow = reach.sway = {};  // which would lead past the place
      } else if (goal.carry) {
        const EffectorPath around = way_around(task, kinematics, *goal.carry);
        reach.path.detour = around.detour;
        reach.path.detour_peak = around.detour_peak;
      } else {
        go_around_obstacles(problem.context, body.effector(reach.effector), reach.path);
      }
    }
    for (const ReachGoal& earlier : problem.goals) {
      if (earlier.effector != reach.effector) continue;
      return fail(ErrorCode::invalid_argument, say("two_goals", goal.effector), "goal");
    }
    // the motion of the hand takes as long as without a late start
    const double load = heaviest_load(task.start);
    const double own = natural ? natural_duration(body, kinematics, reach, load)
                               : goal_duration(body, kinematics, reach) * load_factor(load);
    problem.duration = max(problem.duration, own / (1.0 - reach.path.begin));
    owns.push_back(own);
    problem.goals.push_back(std::move(reach));
  }
  SHG_TRY_ASSIGN(problem.supports, make_supports(task, kinematics));
  SHG_TRY(check_rows(problem));
  if (!problem.rise.empty()) problem.duration = max(problem.duration, kRiseTime);
  if (task.duration) problem.duration = *task.duration;
  // if the duration is short, the hand starts earlier
  for (std::size_t g = 0; g < owns.size(); ++g) {
    double& begin = problem.goals[g].path.begin;
    begin = min(begin, max(1.0 - owns[g] / problem.duration, 0.0));
  }
  for (ReachGoal& goal : problem.goals) carry_on(kinematics, problem.duration, task, goal);
  problem.ease = task.ease;
  problem.gaze_lead = task.gaze_lead;
  problem.hold_limits = problem.posture_law = natural;
  if (natural) problem.windows = natural_windows(problem.goals);
  if (!problem.rise.empty()) problem.windows[static_cast<std::size_t>(TimedPart::hips)] = kHipsRise;
  if (task.preset == Preset::flat) {
    problem.corrections = kLimitCorrections;
    problem.path_slack = kPathSlack;
    problem.smooth = true;
  }
  return problem;
}

Result<Plan> plan_of(const BodyModel& body, const State& start, const Request& request,
                     const CriteriaSettings& criteria) {
  SHG_TRY(check_supports(request));
  const std::optional<LayerStack> stack = traits_of(request.preset).layers;
  if (!stack) return whole_body_plan(body, request.supports);
  return layers_to_goals(body, start, request.goals, {*stack, request.layer_reading}, criteria);
}

Result<ParameterList> parameter_list(const BodyModel& body, const State& start,
                                     const Request& request) {
  SHG_TRY_ASSIGN(const Plan plan, plan_of(body, start, request));
  return parameter_list(plan);
}

}  // namespace shigusa
