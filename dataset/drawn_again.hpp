// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <string>

#include "data_rows.hpp"

namespace shigusa {

// A task of a data set, drawn again, with the parameters of one of its motions.
struct DrawnAgain {
  TaskFile file;
  Task task;
  Parameters parameters;
  // reason why the values do not fit the task's plan, if its body differs; empty: they fit
  std::string misfit{};
};
// `person`: replaces the task's character, if given.
[[nodiscard]] Result<DrawnAgain> drawn_again(const DatasetPlan& plan, const DataMotion& motion,
                                             const CharacterSpec* person = nullptr);

}  // namespace shigusa
