// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <bit>
#include <cstdint>
#include <shigusa/files.hpp>

#include "character/character_fields.hpp"
#include "criteria/built_in_criteria.hpp"
#include "problem/request_fields.hpp"
#include "support/bodies.hpp"

// Random tasks, and their comparison to the last bit.
namespace shigusa::testing_support {

// A random number of the range, sometimes an end of it, of very different magnitudes.
inline double any_number(double low, double high) {
  const double share = static_cast<double>(*rc::gen::arbitrary<std::uint32_t>()) / 4294967295.0;
  const double tiny = share * 1e-300;
  const double value = *rc::gen::element(low + share * (high - low), low, high, tiny, -tiny, -0.0);
  return clamp(value, low, high);
}

inline Vec3d any_point(double range) {
  return {any_number(-range, range), any_number(-range, range), any_number(-range, range)};
}

// Without -0, as for loads: a box of size 0 is left out of files.
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
  const auto doubts = *rc::gen::container<std::vector<std::string>>(
      rc::gen::element<std::string>("a guess", "", "日本\n\t\"\\"));
  spec.doubts.assign(doubts.begin(), doubts.end());
  // any way apart that a limb's joints stand, but never at one point
  Landmarks person = asymmetric_person();
  for (Vec3d* point : all_points(person)) *point += any_point(1e-3);
  if (spec.heels) person.right_leg.toes = any_point(1.0);
  spec.landmarks = person;
  return spec;
}

inline Goal any_goal(const char* effector) {
  Goal goal{effector, any_point(kGoalRange)};
  if (*rc::gen::arbitrary<bool>()) goal.load = any_number(0.0, kLoadMax) + 0.0;
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
  return goal;
}

// A place, or a direction of some length.
inline void any_value(const FieldTraits<ThingHandle, Vec3d>& traits, Vec3d& into) {
  into = any_point(traits.high);
  if (norm(into) < 0.1) into.x = 1.0;
}

// Any value of a plain field, within its bounds.
template <class Traits, class Value>
void any_value(const Traits& traits, Value& into) {
  if constexpr (requires { into.emplace(); }) {
    if (*rc::gen::arbitrary<bool>()) any_value(traits, into.emplace());
  } else if constexpr (std::same_as<Value, bool>) {
    into = *rc::gen::arbitrary<bool>();
  } else if constexpr (std::integral<Value>) {
    const std::uint64_t range = traits.high - traits.low + 1;  // 0: all there are
    const auto any = *rc::gen::arbitrary<std::uint64_t>();
    const std::uint64_t inside = traits.low + (range == 0 ? any : any % range);
    into = static_cast<Value>(*rc::gen::element(traits.low, inside, traits.high));
  } else if constexpr (std::is_enum_v<Value>) {
    const auto& words = kEnumWords<Value>;
    into = words[*rc::gen::inRange<std::size_t>(0, words.size())].value;
  } else if constexpr (std::same_as<Value, double>) {
    into = any_number(traits.low, traits.high) + 0.0;  // -0 counts as not given
  } else if constexpr (std::same_as<Value, Vec3d>) {
    for (int k = 0; k < 3; ++k) into[k] = any_number(traits.low, traits.high);
  } else if constexpr (std::same_as<Value, std::string>) {
    into = *rc::gen::element<std::string>("", "room 1.glb", "部屋 \"1\".glb");
  } else if constexpr (Tabled<Value>) {
    for_each_field<Value>([&](const auto& field) { any_value(field.traits, into.*field.member); });
  } else if constexpr (requires { into.front().size; }) {
    if (!*rc::gen::arbitrary<bool>()) return;
    for (int k = 0; k < 2; ++k) any_value(traits, into.emplace_back());
  } else {
    static_assert(std::same_as<Value, std::vector<std::string>>);
    if (*rc::gen::arbitrary<bool>()) into = {"squat_deg=60", "目", ""};
  }
}

inline void any_value(const FieldTraits<Request, std::vector<Goal>>&, std::vector<Goal>& goals) {
  for (const char* effector : {"right_hand", "left_hand", "", "目"}) {
    if (*rc::gen::arbitrary<bool>()) goals.push_back(any_goal(effector));
  }
}

inline void any_value(const FieldTraits<Request, std::vector<Thing>>&, std::vector<Thing>& things) {
  for (const char* name : {"box", "cup_2"}) {
    if (!*rc::gen::arbitrary<bool>()) continue;
    things.emplace_back();
    for_each_field<Thing>(
        [&](const auto& field) { any_value(field.traits, things.back().*field.member); });
    things.back().name = name;
  }
}

// An action of any kind with any values.
inline Action any_action() {
  const auto place = [](Action& action) {
    action.position = any_point(kGoalRange);
    action.turn_deg = any_number(-180.0, 180.0) + 0.0;
  };
  Action action;
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      action.goals = {any_goal("right_hand"), any_goal("left_hand")};
      action.via = *rc::gen::arbitrary<bool>();
      break;
    case 1:
      action.look_at = any_point(kGoalRange);
      break;
    case 2:
      action.grasp = "box";
      if (*rc::gen::arbitrary<bool>()) action.with = {"left_hand", "right_hand"};
      break;
    case 3:
      action.place = "cup_2";
      place(action);
      break;
    case 4:
      action.stand.emplace();
      break;
    default:
      action.wait = any_number(0.0, kPauseMax) + 0.0;
      break;
  }
  action.hold = any_number(0.0, kPauseMax) + 0.0;
  return action;
}

inline void any_value(const FieldTraits<Request, std::vector<Action>>&,
                      std::vector<Action>& actions) {
  const int count = *rc::gen::inRange(0, 4);
  for (int k = 0; k < count; ++k) actions.push_back(any_action());
}

inline void any_value(const FieldTraits<Request, std::vector<Obstacle>>&,
                      std::vector<Obstacle>& obstacles) {
  if (!*rc::gen::arbitrary<bool>()) return;
  obstacles = {{"目", any_point(kGoalRange), {0.6, -0.0, 0.0, -0.8}, any_tolerance(), 0.5}};
}

inline void any_value(const FieldTraits<Request, std::vector<Support>>&,
                      std::vector<Support>& supports) {
  if (*rc::gen::arbitrary<bool>()) supports = {{"left_hand", "thigh"}, {"", "目"}};
}

inline void any_value(const FieldTraits<Request, CriteriaSettings>&, CriteriaSettings& criteria) {
  for (CriterionSetting& setting : criteria.built_in) {
    setting = {any_number(0.0, 1e6), any_number(1e-9, 1e6)};
  }
  // not all may be 0
  criteria[CriterionKind::torque].weight = any_number(1e-3, 1e6);
}

inline TaskFile any_task() {
  TaskFile task;
  task.character = any_character();
  for_each_field<Request>([&](const auto& field) { any_value(field.traits, task.*field.member); });
  // things and actions are of version 2, which has no goals of its own
  if (task.actions.empty())
    task.things.clear();
  else
    task.goals.clear();
  return task;
}

// All fields of a request, as bits; -0 differs from 0.
class Bits {
 public:
  explicit Bits(const Request& request) { add(request); }
  [[nodiscard]] const std::vector<std::uint64_t>& all() const { return all_; }

 private:
  template <class Value>
  void add(const Value& value) {
    if constexpr (Tabled<Value>) {
      for_each_field<Value>([&](const auto& field) { add(value.*field.member); });
    } else {
      all_.push_back(static_cast<std::uint64_t>(value));
    }
  }
  void add(const double& x) { all_.push_back(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec3d& p) { add(p.x), add(p.y), add(p.z); }
  void add(const Quatd& q) { add(q.x), add(q.y), add(q.z), add(q.w); }
  void add(const std::string& text) { add(std::vector<char>(text.begin(), text.end())); }
  void add(const CriteriaSettings& criteria) {
    for (const CriterionSetting& setting : criteria.built_in) {
      add(setting.weight);
      add(setting.scale);
    }
  }
  template <class Item>
  void add(const std::vector<Item>& list) {
    add(list.size());
    for (const Item& item : list) add(item);
  }
  template <class Value>
  void add(const std::optional<Value>& value) {
    add(value.has_value());
    if (value) add(*value);
  }

  std::vector<std::uint64_t> all_;
};

// All numbers and requests of a character, as bits.
inline std::vector<std::uint64_t> bits(const TaskFile& task) {
  std::vector<std::uint64_t> all = Bits(task).all();
  const auto add = [&all](double x) { all.push_back(std::bit_cast<std::uint64_t>(x)); };
  const CharacterSpec& c = task.character;
  for (const auto& optional : {c.stature, c.mass, c.seat}) {
    all.push_back(optional.has_value());
    add(optional.value_or(0.0));
  }
  all.insert(all.end(),
             {static_cast<std::uint64_t>(c.sex),
              static_cast<std::uint64_t>(c.extent.value_or(BodyExtent::half)),
              static_cast<std::uint64_t>(c.frame.value_or(-2)), c.heels, c.landmarks.has_value()});
  if (!c.landmarks) return all;
  Landmarks person = *c.landmarks;
  for (const Vec3d* point : all_points(person)) add(point->x), add(point->y), add(point->z);
  return all;
}

// All words of a character.
inline std::vector<std::string> words(const CharacterSpec& character) {
  std::vector<std::string> all{character.source, character.animation.value_or("none")};
  all.insert(all.end(), character.doubts.begin(), character.doubts.end());
  for (const auto& [bone, node] : character.map) all.insert(all.end(), {bone, node});
  return all;
}

}  // namespace shigusa::testing_support
