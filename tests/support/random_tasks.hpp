// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <shigusa/files.hpp>
#include <shigusa/run.hpp>

// Random tasks of built-in bodies.
namespace shigusa::testing_support {

// The requests of random tasks.
enum class TaskKind { place, both_hands, rotation, axis, load, obstacle, foot };
inline constexpr std::array kTaskKinds{TaskKind::place, TaskKind::both_hands, TaskKind::rotation,
                                       TaskKind::axis,  TaskKind::load,       TaskKind::obstacle,
                                       TaskKind::foot};
inline TaskKind task_kind(std::uint64_t index) { return kTaskKinds[index % kTaskKinds.size()]; }

// The task of an index, always the same: bodies of all statures, goals within and beyond reach.
inline TaskFile random_task(std::uint64_t index) {
  Random random(1912, index);
  const auto within = [&random](double low, double high) { return random.uniform(low, high); };
  TaskFile file;
  const TaskKind kind = task_kind(index);
  const bool whole = kind == TaskKind::rotation || kind == TaskKind::axis;
  file.character.source = whole || within(0, 1) < 0.7 ? "human" : "full_body";
  file.character.stature = within(1.45, 2.0);
  file.character.sex = within(0, 1) < 0.5 ? Sex::female : Sex::male;
  const bool layered = kind == TaskKind::place && within(0, 1) < 0.25;
  file.preset = layered ? Preset::human : Preset::flat;
  file.seed = index;
  const double size = *file.character.stature;
  const auto place = [&] {
    return Vec3d{within(-0.35, 0.3), within(0.03, 1.1), within(-0.2, 0.45)} * size;
  };
  Goal hand{.effector = "right_hand", .position = place()};
  const auto turn = [&] {
    const Quatd q{within(-1, 1), within(-1, 1), within(-1, 1), within(-1, 1)};
    const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return Quatd{q.x / length, q.y / length, q.z / length, q.w / length};
  };
  switch (kind) {
    case TaskKind::place:
      break;
    case TaskKind::both_hands:
      file.goals.push_back({.effector = "left_hand", .position = place()});
      break;
    case TaskKind::rotation:
      hand.rotation = turn();
      break;
    case TaskKind::axis:
      hand.axis = GoalAxis{{1, 0, 0}, {within(-1, 1), within(-1, 1), within(-1, 1)}};
      break;
    case TaskKind::load:
      hand.load = within(1.0, 40.0);
      break;
    case TaskKind::obstacle:
      file.obstacles.push_back({.name = "box",
                                .position = place() + Vec3d{0, 0, 0.4} * size,
                                .size = Vec3d{0.4, 0.1, 0.2} * size});
      break;
    case TaskKind::foot:
      hand = {.effector = "left_foot",
              .position = Vec3d{within(0.02, 0.25), within(0.05, 0.3), within(-0.1, 0.3)} * size};
      break;
  }
  file.goals.push_back(hand);
  return file;
}

}  // namespace shigusa::testing_support
