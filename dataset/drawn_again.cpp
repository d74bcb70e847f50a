// SPDX-License-Identifier: MIT
#include "drawn_again.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shigusa {
namespace {

// Sets a plan's parameters from a row; returns the name of one that the row lacks, if any.
std::string set_parameters(const Row& row, const ParameterList& list, Parameters& values) {
  const std::vector<std::string>* names = row.table->names_of("parameters");
  const std::vector<double> numbers = row.numbers("parameters");
  if (names == nullptr) return "any";
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::string name = list.all[i].spelled("_rad");
    const auto place = std::find(names->begin(), names->end(), name);
    if (place == names->end()) return name;
    const double value = numbers[static_cast<std::size_t>(place - names->begin())];
    const bool none = !is_finite(value);
    values.locked[i] = none && list.all[i].kind == ParameterKind::weight;
    if (!none) values.values[i] = value;
  }
  return {};
}

}  // namespace

Result<DrawnAgain> drawn_again(const DatasetPlan& plan, const DataMotion& motion,
                               const CharacterSpec* person) {
  SHG_TRY_ASSIGN(DrawnTask drawn, plan.task(motion.number()));
  TaskFile& file = drawn.file;
  if (person != nullptr) {
    const CharacterSpec own = file.character;
    file.character = *person;
    file.character.seat = own.seat;
    file.character.heels = own.heels;
  }
  // the duration found by the search, if the task gives none; each action has its own
  if (file.actions.empty()) file.duration = motion.task.number("duration_s");
  SHG_TRY_ASSIGN(Task task, make_task(file, {}));
  task.batch.threads = 1;
  task.layers.store = limb_store();
  SHG_TRY_ASSIGN(const ParameterList list, parameter_list(task.body, task.start, task));
  Parameters values = list.start();
  values.posed = list.has_posture();
  DrawnAgain again{std::move(file), std::move(task), std::move(values)};
  const std::string unknown = set_parameters(motion.motion, list, again.parameters);
  if (!unknown.empty()) {
    again.misfit = fmt::format("has no value for {}, which this body moves by", unknown);
  } else if (const Result<void> fits = list.check(again.parameters); !fits) {
    again.misfit = fits.error().to_string();
  }
  return again;
}

}  // namespace shigusa
