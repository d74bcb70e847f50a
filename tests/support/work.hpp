// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/files.hpp>
#include <utility>

namespace shigusa::testing_support {

// A box is put up beside a cup that stays.
inline TaskFile box_task() {
  TaskFile file;
  file.things = {{.name = "box", .size = {0.4, 0.3, 0.3}, .mass = 4, .position = {0, 0.15, 0.42}},
                 {.name = "hips",  // also a node of the mannequin
                  .shape = ThingShape::cylinder,
                  .size = {0.08, 0.1, 0.08},
                  .position = {-0.3, 0.9, 0.35}}};
  file.actions = {{.grasp = "box"}, {.place = "box", .position = Vec3d{0, 0.9, 0.45}}};
  file.evaluations = 200;
  file.candidates = 2;
  return file;
}

// A piece of work that was done.
struct Work {
  explicit Work(TaskFile asked)
      : file(std::move(asked)),
        task(make_task(file, {}).value()),
        generation(perform(task).value()) {}
  TaskFile file;
  Task task;
  GenerateResult generation;
};

inline const Work& box_work() {
  static const Work made(box_task());
  return made;
}

}  // namespace shigusa::testing_support
