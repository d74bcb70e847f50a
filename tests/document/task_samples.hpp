// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <bit>
#include <cstdint>
#include <shigusa/document/task_file.hpp>

#include "support/bodies.hpp"

// Random tasks, and whether two are the same to the last bit.
namespace shigusa::testing_support {

// Any number of the range, its ends and numbers of very different sizes among them.
inline double any_number(double low, double high) {
  const double share = static_cast<double>(*rc::gen::arbitrary<std::uint32_t>()) / 4294967295.0;
  const double tiny = share * 1e-300;
  const double value = *rc::gen::element(low + share * (high - low), low, high, tiny, -tiny, -0.0);
  return clamp(value, low, high);
}

inline Vec3d any_point(double range) {
  return {any_number(-range, range), any_number(-range, range), any_number(-range, range)};
}

// Without -0: a box of no size is left out of files.
inline Vec3d any_tolerance() {
  return {any_number(0.0, 10.0) + 0.0, any_number(0.0, 10.0) + 0.0, any_number(0.0, 10.0) + 0.0};
}

inline CharacterSpec any_character() {
  CharacterSpec spec;
  spec.source =
      *rc::gen::element<std::string>("half_body", "full_body", "walk.bvh", "歩く \"1\".bvh");
  if (*rc::gen::arbitrary<bool>()) spec.stature = any_number(0.5, 2.5);
  if (*rc::gen::arbitrary<bool>()) spec.mass = any_number(2.0, 300.0);
  spec.sex = *rc::gen::element(Sex::male, Sex::female);
  if (is_built_in(spec)) return spec;
  spec.extent = *rc::gen::element(BodyExtent::full, BodyExtent::half);
  if (*rc::gen::arbitrary<bool>()) spec.frame = *rc::gen::inRange(kRestPose, 1'000'001);
  if (*rc::gen::arbitrary<bool>()) spec.animation = "walk \"1\"";
  if (*rc::gen::arbitrary<bool>()) spec.seat = any_number(0.1, 1.2);
  spec.heels = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) spec.map = {{"right_hand", "Bone \"17\""}, {"hips", "腰"}};
  if (!*rc::gen::arbitrary<bool>()) return spec;
  spec.stature = any_number(0.5, 2.5);
  spec.doubts = *rc::gen::container<std::vector<std::string>>(
      rc::gen::element<std::string>("a guess", "", "日本\n\t\"\\"));
  // any way apart that a limb's joints stand, but never at one point
  Landmarks person = asymmetric_person();
  for (Vec3d* point : all_points(person)) *point += any_point(1e-3);
  if (spec.heels) person.right_leg.toes = any_point(1.0);
  spec.landmarks = person;
  return spec;
}

inline TaskFile any_task() {
  TaskFile task;
  task.preset = kPresets[*rc::gen::inRange<std::size_t>(0, kPresets.size())].preset;
  task.layer_reading =
      *rc::gen::element(LayerReading::shared_contractions, LayerReading::contraction_a_limb);
  task.character = any_character();
  for (const char* name : {"right_hand", "left_hand", "", "目"}) {
    if (*rc::gen::arbitrary<bool>()) task.goals.push_back({name, any_point(kGoalRange)});
  }
  for (Goal& goal : task.goals) {
    if (*rc::gen::arbitrary<bool>()) goal.load = any_number(0.0, 500.0);
    if (*rc::gen::arbitrary<bool>()) goal.tolerance = any_tolerance();
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        goal.rotation = Quatd{0.6, -0.0, 0.0, -0.8};
        break;
      case 1:
        goal.axis = GoalAxis{any_point(kGoalRange), any_point(kGoalRange)};
        break;
      default:
        break;
    }
  }
  if (*rc::gen::arbitrary<bool>()) task.look_at = any_point(kGoalRange);
  if (*rc::gen::arbitrary<bool>()) task.contacts = {"right_foot", "", "目"};
  if (*rc::gen::arbitrary<bool>()) task.duration = any_number(0.05, 60.0);
  for_each_criterion([&](const auto& criterion) {
    criterion.weight(task.criteria) = any_number(0.0, 1e6);
    criterion.scale(task.criteria) = any_number(1e-9, 1e6);
  });
  // not all may be 0
  task.criteria.torque_weight = any_number(1e-3, 1e6);
  task.seed =
      *rc::gen::element<std::uint64_t>(0, 1, UINT64_MAX, *rc::gen::arbitrary<std::uint64_t>());
  task.candidates = *rc::gen::inRange(1, 1001);
  if (*rc::gen::arbitrary<bool>()) task.fixed_assignments = {"squat_deg=60", "目", ""};
  task.pareto = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) task.generator = MotionGenerator::nlp_ik;
  task.phases = *rc::gen::inRange(1, kPhasesMax + 1);
  if (*rc::gen::arbitrary<bool>()) task.evaluations = *rc::gen::inRange(8, 1'000'000'001);
  return task;
}

// All numbers of a task as bits; -0 is not 0 here.
inline std::vector<std::uint64_t> bits(const TaskFile& task) {
  std::vector<std::uint64_t> all;
  const auto add = [&all](double x) { all.push_back(std::bit_cast<std::uint64_t>(x)); };
  const auto add_point = [&add](const Vec3d& p) { add(p.x), add(p.y), add(p.z); };
  const CharacterSpec& c = task.character;
  for (const auto& optional : {c.stature, c.mass, c.seat, task.duration}) {
    all.push_back(optional.has_value());
    add(optional.value_or(0.0));
  }
  all.insert(all.end(),
             {static_cast<std::uint64_t>(c.sex),
              static_cast<std::uint64_t>(c.extent.value_or(BodyExtent::half)),
              static_cast<std::uint64_t>(c.frame.value_or(-2)), c.landmarks.has_value(), task.seed,
              task.pareto, static_cast<std::uint64_t>(task.generator),
              static_cast<std::uint64_t>(task.phases), static_cast<std::uint64_t>(task.candidates),
              static_cast<std::uint64_t>(task.evaluations.value_or(-1))});
  if (c.landmarks) {
    Landmarks person = *c.landmarks;
    for (const Vec3d* point : all_points(person)) add_point(*point);
  }
  for (const Goal& goal : task.goals) {
    add_point(goal.position);
    add_point(goal.tolerance);
    all.push_back(goal.rotation.has_value());
    all.push_back(goal.axis.has_value());
    const Quatd q = goal.rotation.value_or(Quatd{});
    for (const double part : {q.x, q.y, q.z, q.w}) add(part);
    const GoalAxis axis = goal.axis.value_or(GoalAxis{});
    add_point(axis.axis);
    add_point(axis.direction);
  }
  all.push_back(task.look_at.has_value());
  add_point(task.look_at.value_or(Vec3d{}));
  for_each_criterion([&](const auto& criterion) {
    add(criterion.weight(task.criteria));
    add(criterion.scale(task.criteria));
  });
  return all;
}

// All words of a task.
inline std::vector<std::string> words(const TaskFile& task) {
  std::vector<std::string> all{task.character.source, std::string(word_of(task.preset)),
                               std::string(word_of(task.layer_reading))};
  all.insert(all.end(), task.character.doubts.begin(), task.character.doubts.end());
  all.push_back(task.character.animation.value_or("none"));
  for (const auto& [bone, node] : task.character.map) all.insert(all.end(), {bone, node});
  for (const Goal& goal : task.goals) all.push_back(goal.effector);
  all.insert(all.end(), task.fixed_assignments.begin(), task.fixed_assignments.end());
  if (task.contacts) {
    all.emplace_back("contacts");
    all.insert(all.end(), task.contacts->begin(), task.contacts->end());
  }
  return all;
}

}  // namespace shigusa::testing_support
