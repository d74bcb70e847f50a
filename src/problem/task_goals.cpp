// SPDX-License-Identifier: MIT
#include "task_goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
#include <utility>

#include "body/joint_name.hpp"
#include "body/load.hpp"
#include "body/sole.hpp"
#include "body/stance.hpp"
#include "core/say.hpp"

namespace shigusa {
namespace {

// Lift (m) of a stepping foot, with a share of the step's length: toes clear the floor.
constexpr double kStepLift = 0.05;
constexpr double kStepLiftShare = 0.12;
constexpr double kStepLiftMax = 0.15;
// Least length (m) of a step along the floor.
constexpr double kLeastStep = 0.01;

tl::unexpected<Error> wrong_goal(const Goal& goal, Message message) {
  return fail(ErrorCode::invalid_argument, std::move(message), "goal of " + goal.effector);
}

Result<int> effector_index(const BodyModel& body, const Goal& goal) {
  if (const auto index = body.find_effector(goal.effector)) return *index;
  const Foot* base = base_foot(body);
  if (base != nullptr && base->name == goal.effector) {
    return fail(ErrorCode::invalid_argument, say("foot_bears", base->name), "goal");
  }
  return fail(ErrorCode::not_found, unknown_name("effector", goal.effector, goal_names(body)),
              "goal");
}

Result<void> check_turn(const Goal& goal) {
  if (goal.rotation && goal.axis) {
    return wrong_goal(goal, say("turn_twice"));
  }
  if (goal.rotation && !is_unit(*goal.rotation)) {
    const Quatd& q = *goal.rotation;
    return wrong_goal(goal, say("no_unit_quaternion", q.x, q.y, q.z, q.w, sqrt(squared_length(q))));
  }
  if (!goal.axis) return {};
  for (const Vec3d& v : {goal.axis->axis, goal.axis->direction}) {
    const double length = norm(v);
    if (length > 1e-6 && length <= kGoalRange) continue;
    return wrong_goal(goal, say("axis_vector", v.x, v.y, v.z));
  }
  return {};
}

Result<void> check_goal(const Goal& goal) {
  if (!(goal.load >= 0.0 && goal.load <= kLoadMax)) {
    return wrong_goal(goal, say("load_range", goal.load, kLoadMax));
  }
  for (int k = 0; k < 3; ++k) {
    const double x = goal.position[k];
    const double half = goal.tolerance[k];
    if (!(x >= -kGoalRange && x <= kGoalRange)) {
      return wrong_goal(goal, say(
                                  "coordinate_range", "xyz" [k], Metres { x }, Metres{kGoalRange},
                                  Metres{kGoalRange}));
    }
    if (half >= 0.0 && half <= kToleranceMax) continue;
    return wrong_goal(goal,
                      say(
                          "tolerance_range", "xyz" [k], Metres { half }, Metres{kToleranceMax}));
  }
  return check_turn(goal);
}

// The offset (m) of a bow of 1 on a path to `offset` from its start: forwards, perpendicular to the
// path; upwards for a path that leads forwards.
Vec3d bow_of(const Vec3d& offset) {
  const double length = norm(offset);
  const Vec3d along = normalized(offset);
  for (const Vec3d& out : {Vec3d{0, 0, 1}, Vec3d{0, 1, 0}}) {
    const Vec3d square = out - along * dot(along, out);
    if (norm(square) > 0.5) return normalized(square) * length;
  }
  return {};
}

// The offset (m) of a sway of 1 on a path to `offset` from its start: perpendicular to path and
// bow, outwards on the effector's side; upwards for a path that leads sideways.
Vec3d sway_of(const Vec3d& offset, const Vec3d& bow, const Effector& effector) {
  const Vec3d out{effector.part.side == Side::left ? 1.0 : -1.0, 0.1, 0.0};
  const Vec3d sway = cross(normalized(offset), bow);
  return dot(sway, out) < 0.0 ? -sway : sway;
}

// The goal of an effector that keeps to a thing: all hands on it make the same bow and sway.
ReachGoal carried(ReachGoal reach, const Effector& effector, const Carry& carry,
                  const Kinematics<double>& start) {
  const Mat3d from = to_matrix(carry.from_turn);
  const Mat3d to = to_matrix(carry.to_turn);
  const Vec3d at = start.point(effector.link, effector.point);
  CarriedWay& way = reach.carry.emplace();
  way.start = carry.from;
  way.goal = carry.to;
  way.from = from;
  way.turn = rotation_vector(to * transpose(from));
  way.grip = transpose_times(from, at - way.start);
  way.hand = transpose(from) * start.link_rotation(effector.link);
  const Vec3d offset = way.goal - way.start;
  reach.path.goal = reach.place_at(1.0);
  reach.turn.kind = Turning::whole;
  reach.turn.goal = reach.turn_at(1.0);
  reach.bow = bow_of(offset);
  const Vec3d sway = cross(normalized(offset), reach.bow);
  reach.sway = sway.x < 0.0 ? -sway : sway;
  return reach;
}

// Whether an effector's link carries the sole of a leg that hangs from the pelvis: the link of its
// ankle, or of its toes if heels lift.
bool is_foot(const BodyModel& body, int effector) {
  const Effector& e = body.effector(effector);
  const JointPlace& end = body.dof(e.link).part;
  if (body.dof(e.limb_root).part.joint_kind != JointKind::hip) return false;
  return end.joint_kind == JointKind::toes ||
         (end.joint_kind == JointKind::ankle &&
          !body.find_dof(JointKind::toes, FreedomKind::flexion, end.side));
}

// The goal's effector, if the body has it.
const Effector* effector_of(const BodyModel& body, const Goal& goal) {
  const auto index = body.find_effector(goal.effector);
  return index ? &body.effector(*index) : nullptr;
}

bool moves_foot(const Task& task, const Foot& foot) {
  return std::any_of(task.goals.begin(), task.goals.end(), [&](const Goal& goal) {
    const Effector* effector = effector_of(task.body, goal);
    return effector != nullptr && effector->link == foot.link;
  });
}

// Renames goals by a foot's name to its sole's node, as the node loses the foot's name once the
// foot does not stand.
void name_soles(Task& task) {
  for (const Foot& foot : task.body.feet()) {
    for (Goal& goal : task.goals) {
      const Effector* effector = effector_of(task.body, goal);
      if (effector != nullptr && effector->name == foot.name) goal.effector = effector->node;
    }
  }
}

// Distance (m) that a sole may end below the floor: the tolerance of goals.
constexpr double kSoleSlack = kReachTolerance;

// Fails if a goal would move a foot below the floor.
Result<void> check_soles(const Task& task, const Kinematics<double>& start) {
  for (const Goal& goal : task.goals) {
    const auto index = task.body.find_effector(goal.effector);
    if (!index) continue;
    const Effector& effector = task.body.effector(*index);
    for (const Foot& foot : task.body.feet()) {
      if (effector.link != foot.link) continue;
      const Sole sole = sole_under(foot, effector.point,
                                   {start.link_rotation(foot.link), start.link_origin(foot.link)});
      const EffectorTurn turn = goal_turn(task.body, goal, *index, start);
      const double least = turn.kind == Turning::axis ? sole.least_height(turn.axis, turn.direction)
                                                      : sole.least_height(turn.goal);
      if (goal.position.y >= least - kSoleSlack) continue;
      return wrong_goal(goal, say("sole_below_floor", Metres{goal.position.y},
                                  Millimetres{1000.0 * (least - goal.position.y)},
                                  Metres{std::ceil(1000.0 * least) / 1000.0}));
    }
  }
  return {};
}

Result<void> check_contacts(const Task& task) {
  std::vector<std::string> feet;
  for (const Foot& foot : task.body.feet()) feet.push_back(foot.name);
  for (const std::string& name : *task.contacts) {
    if (std::find(feet.begin(), feet.end(), name) != feet.end()) continue;
    return fail(ErrorCode::not_found, unknown_name("contact", name, feet), "contacts");
  }
  const Foot* base = base_foot(task.body);
  if (base == nullptr) return {};
  const auto& kept = *task.contacts;
  if (std::find(kept.begin(), kept.end(), base->name) != kept.end()) return {};
  return fail(ErrorCode::invalid_argument, say("foot_bears_contact", base->name), "contacts");
}

// Whether hands have loads that the body lacks, or feet do not stand.
bool needs_preparing(const Task& task) {
  const auto loaded = [](const Goal& goal) { return goal.load != 0.0; };
  const auto feet = task.body.feet();
  return task.contacts || task.start.held != task.home.held ||
         std::any_of(task.goals.begin(), task.goals.end(), loaded) ||
         std::any_of(feet.begin(), feet.end(),
                     [&](const Foot& foot) { return moves_foot(task, foot); });
}

// Frees the feet that do not stand.
Result<void> stand(Task& task) {
  if (task.contacts) SHG_TRY(check_contacts(task));
  const Kinematics<double> start = placed(task.body, task.start);
  SHG_TRY(check_soles(task, start));
  name_soles(task);
  std::vector<std::string> standing;
  std::vector<Goal> lifts;
  for (const Foot& foot : task.body.feet()) {
    const bool moves = moves_foot(task, foot);
    const bool kept = !task.contacts || std::find(task.contacts->begin(), task.contacts->end(),
                                                  foot.name) != task.contacts->end();
    if (task.contacts && kept && moves) {
      return fail(ErrorCode::invalid_argument, say("stands_and_goal", foot.name), "contacts");
    }
    if (kept && !moves) standing.push_back(foot.name);
    const auto effector = task.body.find_effector(foot.node);
    if (kept || moves || !effector) continue;
    const Effector& ankle = task.body.effector(*effector);
    lifts.push_back({.effector = foot.node,
                     .position = start.point(ankle.link, ankle.point) + Vec3d{0, kFootLift, 0}});
  }
  if (standing.size() < task.body.feet().size()) task.body = standing_on(task.body, standing);
  task.goals.insert(task.goals.end(), lifts.begin(), lifts.end());
  task.contacts.reset();
  return {};
}

}  // namespace

Result<void> check_start(const Task& task) {
  const std::vector<double>& angles = task.start.angles;
  for (const std::vector<double>* numbers : {&angles, &task.start.velocities}) {
    if (numbers->empty() && numbers != &angles) continue;
    const bool finite =
        std::all_of(numbers->begin(), numbers->end(), [](double q) { return is_finite(q); });
    if (numbers->size() == task.body.dofs().size() && finite) continue;
    return fail(ErrorCode::invalid_argument,
                say("start_state", task.body.dof_count(), numbers->size()), "start");
  }
  for (const HeldLoad& load : task.start.held) {
    if (load.mass >= 0.0 && load.mass <= kLoadMax) continue;
    return fail(ErrorCode::invalid_argument, say("load_range", load.mass, kLoadMax), "start");
  }
  if (!task.start.velocities.empty() && task.generator == MotionGenerator::nlp_ik) {
    return fail(ErrorCode::invalid_argument, say("start_at_rest"), "start");
  }
  const PresetTraits& preset = traits_of(task.preset);
  if (!preset.layers || task.start.velocities.empty()) return {};
  return fail(ErrorCode::invalid_argument, say("start_of_layers", preset.word), "start");
}

EffectorTurn goal_turn(const BodyModel& body, const Goal& goal, int effector,
                       const Kinematics<double>& start) {
  EffectorTurn turn;
  turn.start = turn.goal = start.link_rotation(body.effector(effector).link);
  if (goal.rotation) {
    const Quatd& q = *goal.rotation;
    const double scale = 1.0 / sqrt(squared_length(q));
    turn.goal = to_matrix(Quatd{q.x * scale, q.y * scale, q.z * scale, q.w * scale});
    turn.kind = Turning::whole;
  } else if (goal.axis) {
    turn.axis = normalized(goal.axis->axis);
    turn.direction = normalized(goal.axis->direction);
    turn.kind = Turning::axis;
  } else if (is_foot(body, effector)) {
    turn.kind = Turning::whole;
  }
  return turn;
}

Result<ReachGoal> make_reach_goal(const BodyModel& body, const Kinematics<double>& start,
                                  const Goal& goal) {
  SHG_TRY_ASSIGN(const int index, effector_index(body, goal));
  SHG_TRY(check_goal(goal));
  const Effector& effector = body.effector(index);
  const Vec3d from = start.point(effector.link, effector.point);
  const Vec3d offset = goal.position - from;
  ReachGoal reach;
  reach.effector = index;
  reach.path = {from, goal.position};
  reach.turn = goal_turn(body, goal, index, start);
  reach.tolerance = goal.tolerance;
  if (is_foot(body, index)) {
    // neither through the floor nor far above it
    const double length = norm(Vec3d{offset.x, 0.0, offset.z});
    if (length > kLeastStep) {
      reach.path.detour.y = min(kStepLift + kStepLiftShare * length, kStepLiftMax);
    }
    return reach;
  }
  if (goal.carry) return carried(std::move(reach), effector, *goal.carry, start);
  reach.bow = bow_of(offset);
  reach.sway = sway_of(offset, reach.bow, effector);
  return reach;
}

double goal_miss(const Goal& goal, const Vec3d& at) {
  const ReachGoal box{.path = {.goal = goal.position}, .tolerance = goal.tolerance};
  return norm(box.nearest(at) - at);
}

double goal_duration(const BodyModel& body, const Kinematics<double>& start,
                     const ReachGoal& goal) {
  const Effector& effector = body.effector(goal.effector);
  const Vec3d root = start.origin[static_cast<std::size_t>(effector.limb_root)];
  const bool beyond_limb = norm(goal.path.goal - root) > body.limb_length(effector);
  return reach_duration(norm(goal.path.goal - goal.path.start), beyond_limb);
}

Result<void> check_rows(const ReachProblem& problem) {
  int rows = 0;
  for (const Constraint<double>& constraint : constraints(problem)) rows += constraint.rows();
  if (rows <= kMaxIkRows) return {};
  return fail(ErrorCode::invalid_argument, say("too_many_rows", rows, kMaxIkRows), "goals");
}

std::optional<Vec3d> gaze_of(const BodyModel& body, std::span<const Goal> goals) {
  std::optional<Vec3d> first;
  Vec3d hands{};
  int count = 0;
  for (const Goal& goal : goals) {
    const auto index = body.find_effector(goal.effector);
    const bool limb = !index || *index < static_cast<int>(body.effectors().size()) ||
                      body.effector(*index).part.side;
    if (limb && !first) first = goal.position;
    if (!index || parse_joint_name(goal.effector).joint_kind != JointKind::hand) continue;
    hands += goal.position;
    ++count;
  }
  return count == 2 ? hands * 0.5 : first;
}

// Adds the loads of the start to the body, which holds those of its home.
void take_loads(Task& task) {
  for (std::size_t k = task.home.held.size(); k < task.start.held.size(); ++k) {
    task.body = with_load(task.body, task.start.held[k]);
  }
  task.home.held = task.start.held;
}

std::vector<HeldLoad> loads_in_hands(const Task& task) {
  std::vector<HeldLoad> loads = task.start.held;
  for (const Goal& goal : task.goals) {
    if (!(goal.load > 0.0)) continue;
    if (const auto hand = task.body.find_effector(goal.effector)) {
      loads.push_back({.effector = *hand, .mass = goal.load});
    }
  }
  return loads;
}

Result<Task> standing(Task task) {
  SHG_TRY(check_start(task));
  if (!needs_preparing(task)) return task;
  for (Goal& goal : task.goals) {
    SHG_TRY_ASSIGN(const int effector, effector_index(task.body, goal));
    SHG_TRY(check_goal(goal));
    if (goal.load > 0.0) task.start.held.push_back({effector, goal.load});
    goal.load = 0.0;
  }
  take_loads(task);
  SHG_TRY(stand(task));
  return task;
}

}  // namespace shigusa
