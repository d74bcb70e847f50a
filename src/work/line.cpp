// SPDX-License-Identifier: MIT
#include "work/line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "body/load.hpp"
#include "core/check.hpp"
#include "core/index.hpp"
#include "problem/rise.hpp"
#include "work/check_work.hpp"
#include "work/over.hpp"

namespace shigusa {
namespace {

// Height (m) by which a grasped thing is lifted clear.
constexpr double kLift = 0.05;
// Place of a carried thing: its near side ahead of the hips (m), and its middle above them.
constexpr double kBellyAhead = 0.16;
constexpr double kBellyAbove = 0.08;
// Part (m) of half a thing's width that fits between a hanging hand and the leg, chosen.
constexpr double kBesideLeg = 0.05;
// Downward part of the fingers' direction from which an arm can hang with a thing.
constexpr double kFingersDown = 0.5;
// Distance (m) of a hand from where it hangs up to which it stays there.
constexpr double kHangs = 0.12;
// Half the sides (m) of the box above what is in the way in which any place will do.
constexpr Vec3d kClearWithin{0.05, 0.05, 0.05};
// Tolerance (m) of hips and head in standing, and distance (m) at which the eyes look.
constexpr Vec3d kUpright{0.02, 0.008, 0.02};
constexpr double kLooksAhead = 3.0;
// Lean (rad) from which the first low posture tells the habit of the knees.
constexpr double kTellsHabit = radians(30.0);

// Makes an obstacle smaller by kTouch on all sides.
void give_way(Obstacle& obstacle) {
  const double off = min(obstacle.radius, kTouch);
  obstacle.radius -= off;
  for (const int k : {0, 1, 2}) {
    obstacle.size[k] = max(obstacle.size[k] - 2.0 * (kTouch - off), 0.0);
  }
}

std::uint64_t seed_of(const Task& task, std::size_t piece) {
  return task.seed ^ (piece * 0x9e3779b97f4a7c15U);
}

}  // namespace

Line::Line(const Task& task) : task_(&task) {
  now_.angles = task.start.angles;
  for (const Thing& thing : task.things) now_.things.push_back(start_pose(thing));
}

std::size_t Line::thing_of(const Action& action) const {
  const std::string& name = !action.grasp.empty()   ? action.grasp
                            : !action.place.empty() ? action.place
                                                    : action.release;
  return thing_named(*task_, name);
}

void Line::make(std::size_t action, const Step& step) {
  const Action& asked = task_->actions[action];
  switch (step.kind) {
    case StepKind::take: {
      // the hands of the reach before hold it
      const std::size_t thing = thing_of(asked);
      const Kinematics<double> placed_now =
          placed(task_->body, {.angles = now_.angles, .velocities = {}, .held = {}});
      const std::vector<Grip> before = now_.on(thing);
      for (const GoalResult& goal : pieces_[pieces_.size() - 2].candidate->goals) {
        const int hand = task_->body.find_effector(goal.asked.effector).value();
        if (now_.in(hand)) continue;
        const int link = task_->body.effector(hand).link;
        const Transformd place{placed_now.link_rotation(link), placed_now.link_origin(link)};
        now_.grips.push_back({hand, link, thing, inverse(place) * now_.things[thing]});
      }
      // a hand that held it alone lets go
      std::erase_if(now_.grips, [&](const Grip& grip) {
        return grip.thing == thing && !before.empty() && grip.hand == before.front().hand;
      });
      return;
    }
    case StepKind::let_go: {
      const std::size_t thing = thing_of(asked);
      std::erase_if(now_.grips, [thing](const Grip& grip) { return grip.thing == thing; });
      return;
    }
    default: {
      const int frames = static_cast<int>(std::lround(step.seconds * kWorkRate)) + 1;
      Piece piece{.action = action, .body = task_->body};
      piece.clip = {.dofs = task_->body.dof_count(),
                    .frames = frames,
                    .frame_time = 1.0 / kWorkRate,
                    .angles = {}};
      for (int f = 0; f < frames; ++f) {
        piece.clip.angles.insert(piece.clip.angles.end(), now_.angles.begin(), now_.angles.end());
      }
      for (const HeldLoad& load : state_of(task_->body, task_->things, now_).held) {
        piece.body = with_load(piece.body, load);
      }
      keep(piece);
      return;
    }
  }
}

Task Line::plain() const {
  Task task = *task_;
  task.actions.clear();
  task.things.clear();
  task.start = state_of(task_->body, task_->things, now_);
  if (is_new()) task.start.velocities = task_->start.velocities;
  task.duration.reset();
  for (std::size_t t = 0; t < task_->things.size(); ++t) {
    if (!now_.on(t).empty()) continue;
    for (Obstacle& part : obstacles_of(task_->things[t], now_.things[t])) {
      task.obstacles.push_back(std::move(part));
    }
  }
  task.seed = seed_of(*task_, pieces_.size());
  if (knees_ && task.habit == Habit{}) {
    Habit habit;
    habit.knees = *knees_;
    adopt_habit(task, habit);
  }
  return task;
}

std::vector<Goal> Line::carried(std::size_t thing, const Transformd& to, bool rigid) const {
  const Kinematics<double> at = placed(task_->body, {.angles = now_.angles});
  const Transformd& from = now_.things[thing];
  std::vector<Goal> goals;
  for (const Grip& grip : now_.on(thing)) {
    const Effector& hand = task_->body.effector(grip.hand);
    const Transformd link = to * inverse(grip.in_hand);
    Goal& goal = goals.emplace_back();
    goal.effector = hand.name;
    goal.position = link * hand.point;
    goal.rotation = to_quat(link.rotation);
    if (!rigid) continue;
    goal.carry =
        Carry{from.translation, to_quat(from.rotation), to.translation, to_quat(to.rotation)};
  }
  return goals;
}

Task Line::carries(std::size_t thing, const Transformd& to, bool rigid) const {
  Task task = plain();
  const bool two = now_.on(thing).size() > 1;
  task.goals = carried(thing, to, rigid || two || task_->things[thing].upright);
  if (!task.look_at) task.look_at = to.translation;
  return task;
}

Task Line::goes(std::size_t number) const {
  const Action& action = task_->actions[number];
  Task task = plain();
  task.goals = action.goals;
  if (const Action* via = via_before(*task_, number)) {
    for (const Goal& passed : via->goals) {
      for (Goal& goal : task.goals) {
        if (goal.effector == passed.effector) goal.via = passed.position;
      }
    }
  }
  if (action.look_at) task.look_at = action.look_at;
  task.duration = action.duration;
  const auto moves = [&](const Grip& grip) {
    const std::string& name = task_->body.effector(grip.hand).name;
    return std::any_of(task.goals.begin(), task.goals.end(),
                       [&](const Goal& goal) { return goal.effector == name; });
  };
  // what is in two hands, or is to stay upright, stays where it is
  for (std::size_t t = 0; t < task_->things.size(); ++t) {
    const std::vector<Grip> grips = now_.on(t);
    const bool keeps = grips.size() > 1 || (grips.size() == 1 && task_->things[t].upright);
    if (!keeps || std::any_of(grips.begin(), grips.end(), moves)) continue;
    for (Goal& goal : carried(t, now_.things[t], true)) task.goals.push_back(std::move(goal));
  }
  if (!task.goals.empty()) return task;
  // to look alone, the hands stay
  const Kinematics<double> at = placed(task_->body, {.angles = now_.angles});
  for (const Effector& hand : task_->body.effectors()) {
    task.goals.push_back({.effector = hand.name, .position = at.point(hand.link, hand.point)});
  }
  return task;
}

std::vector<Task> Line::reaches(const Action& action) const {
  const std::size_t thing = thing_of(action);
  const Kinematics<double> at = placed(task_->body, {.angles = now_.angles});
  const Task task = plain();
  std::vector<Obstacle> others = task.obstacles;
  const std::string& name = task_->things[thing].name;
  std::erase_if(others, [&](const Obstacle& other) { return other.name == name; });
  std::vector<Task> tasks;
  for (std::vector<Goal>& goals :
       holds_of(task_->body, at, task_->things[thing], now_.things[thing], action.with, others,
                put_higher(action))) {
    const bool full = std::any_of(goals.begin(), goals.end(), [&](const Goal& goal) {
      return now_.in(task_->body.find_effector(goal.effector).value()).has_value();
    });
    if (full) continue;
    Task& one = tasks.emplace_back(task);
    one.goals = std::move(goals);
    // a hand that holds it meanwhile stays
    for (Goal& goal : carried(thing, now_.things[thing], true)) {
      one.goals.push_back(std::move(goal));
    }
    for (Obstacle& obstacle : one.obstacles) {
      if (obstacle.name == name) give_way(obstacle);
    }
    one.duration = action.duration;
    if (!one.look_at) one.look_at = now_.things[thing].translation;
  }
  return tasks;
}

std::vector<Task> Line::clears(const Action& action) const {
  if (is_new()) return {};
  const std::vector<Task> tasks = reaches(action);
  if (tasks.empty()) return {};
  Task task = tasks.front();
  const Kinematics<double> at = placed(task_->body, {.angles = now_.angles});
  bool passes = false;
  for (Goal& goal : task.goals) {
    const Effector& hand = task_->body.effector(task_->body.find_effector(goal.effector).value());
    const Vec3d from = at.point(hand.link, hand.point);
    const auto place = place_over(task.obstacles, from, goal.position);
    passes = passes || place;
    goal = {.effector = goal.effector,
            .position = place.value_or(from),
            .tolerance = place ? kClearWithin : Vec3d{}};
  }
  task.duration.reset();
  if (!passes) return {};
  return {std::move(task)};
}

double Line::put_higher(const Action& grasp) const {
  const auto first = task_->actions.begin() + (&grasp - task_->actions.data());
  const auto put = std::find_if(first, task_->actions.end(), [&grasp](const Action& later) {
    return later.place == grasp.grasp;
  });
  if (put == task_->actions.end()) return 0.0;
  return put->position->y - now_.things[thing_of(grasp)].translation.y;
}

Vec3d Line::before_belly(const Thing& thing) const {
  const Kinematics<double> home = placed(task_->body, task_->home);
  const BodyNode* hips = task_->body.find_node(humanoid_bone_name(HumanoidBone::hips));
  const Vec3d at = hips == nullptr ? Vec3d{0, 1, 0} : home.point(hips->link, hips->point);
  return {at.x, at.y + kBellyAbove, at.z + kBellyAhead + 0.5 * thing.size.z};
}

bool Line::hangs_from(std::size_t thing, const Grip& grip) const {
  const Thing& held = task_->things[thing];
  if (!held.handle || held.handle->position.y < 0.5 * held.size.y) return false;
  const Kinematics<double> home = placed(task_->body, task_->home);
  const Kinematics<double> at = placed(task_->body, {.angles = now_.angles});
  const Vec3d fingers = transpose_times(home.link_rotation(grip.link), Vec3d{0, -1, 0});
  return (at.link_rotation(grip.link) * fingers).y < -kFingersDown;
}

Vec3d Line::beside_leg(std::size_t thing, const Grip& grip) const {
  const Kinematics<double> home = placed(task_->body, task_->home);
  const Effector& hand = task_->body.effector(grip.hand);
  const Thing& held = task_->things[thing];
  const double side = hand.part.side == Side::left ? 1.0 : -1.0;
  Vec3d to = home.point(hand.link, hand.point);
  to.x += side * max(0.5 * held.size.x - kBesideLeg, 0.0);
  const Vec3d from_middle = now_.things[thing].rotation * (inverse(grip.in_hand) * hand.point);
  Vec3d middle = to - from_middle;
  middle.y = max(middle.y, 0.5 * held.size.y + kLift);
  return middle;
}

Task Line::rises(bool arms) const {
  Task task = plain();
  const Kinematics<double> home = placed(task_->body, task_->home);
  for (std::size_t t = 0; t < task_->things.size(); ++t) {
    const std::vector<Grip> grips = now_.on(t);
    if (grips.empty()) continue;
    const Thing& thing = task_->things[t];
    Vec3d place = before_belly(thing);
    if (grips.size() == 1) {
      place.x = home.point(grips[0].link, task_->body.effector(grips[0].hand).point).x;
    }
    if (grips.size() == 1 && hangs_from(t, grips[0])) place = beside_leg(t, grips[0]);
    Transformd to = now_.things[t];
    to.translation = place;
    for (Goal& goal : carried(t, to, grips.size() > 1 || thing.upright)) {
      if (grips.size() == 1 && !thing.upright) goal.rotation.reset();
      task.goals.push_back(std::move(goal));
    }
  }
  // the arms of who is bent would catch on the thighs on a way of their own
  const bool bent = !rise_of(task.body, criteria_context(task)).empty();
  for (const Effector& hand : task_->body.effectors()) {
    if ((bent && !arms) || now_.in(task_->body.find_effector(hand.name).value())) continue;
    task.goals.push_back({.effector = hand.name, .position = home.point(hand.link, hand.point)});
  }
  // upright again: hips and head where they were
  for (const HumanoidBone bone : {HumanoidBone::hips, HumanoidBone::head}) {
    const auto effector = task_->body.find_effector(humanoid_bone_name(bone));
    if (!effector) continue;
    const Effector& part = task_->body.effector(*effector);
    const Vec3d at = home.point(part.link, part.point);
    task.goals.push_back({.effector = part.name, .position = at, .tolerance = kUpright});
    if (bone == HumanoidBone::head) task.look_at = at + Vec3d{0, 0, kLooksAhead};
  }
  return task;
}

bool Line::hangs() const {
  const Kinematics<double> home = placed(task_->body, task_->home);
  const Kinematics<double> at = placed(task_->body, {.angles = now_.angles});
  const auto hands = task_->body.effectors();
  return std::all_of(hands.begin(), hands.end(), [&](const Effector& hand) {
    return now_.in(task_->body.find_effector(hand.name).value()) ||
           norm(at.point(hand.link, hand.point) - home.point(hand.link, hand.point)) < kHangs;
  });
}

std::vector<Task> Line::tasks_of(std::size_t action, const Step& step) const {
  const Action& asked = task_->actions[action];
  switch (step.kind) {
    case StepKind::go:
      return {goes(action)};
    case StepKind::clear:
      return clears(asked);
    case StepKind::reach:
      return reaches(asked);
    case StepKind::lift: {
      Transformd up = now_.things[thing_of(asked)];
      up.translation.y += kLift;
      return {carries(thing_of(asked), up, true)};
    }
    case StepKind::carry: {
      Task task = carries(thing_of(asked), upright_pose(*asked.position, asked.turn_deg), false);
      task.duration = asked.duration;
      return {std::move(task)};
    }
    case StepKind::rise:
      return {rises(false), rises(true)};
    case StepKind::hang:
      return hangs() ? std::vector<Task>{} : std::vector<Task>{rises(false)};
    default:
      return {};
  }
}

void Line::add(std::size_t action, const BodyModel& body, Candidate candidate, int way) {
  Piece piece{.action = action, .body = body, .way = way};
  const FinalPosture& posture = candidate.final_posture;
  if (!knees_ && posture.trunk_lean > kTellsHabit) {
    knees_ = clamp(posture.knee_flexion / posture.trunk_lean, 0.0, kHabitKneesMost);
  }
  piece.clip = motion_at(body, candidate, kWorkRate);
  piece.candidate = std::move(candidate);
  keep(piece);
}

void Line::keep(const Piece& piece) {
  Piece& kept = pieces_.emplace_back(piece);
  kept.grips = now_.grips;
  kept.things = now_.things;
  const auto last = kept.clip.frame(kept.clip.frames - 1);
  now_.angles.assign(last.begin(), last.end());
  const Kinematics<double> at = placed(task_->body, {.angles = now_.angles});
  for (std::size_t t = 0; t < now_.things.size(); ++t) {
    if (const std::vector<Grip> grips = now_.on(t); !grips.empty()) {
      now_.things[t] = held_pose(at, grips);
    }
  }
}

}  // namespace shigusa
