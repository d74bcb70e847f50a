// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <string>

#include "table.hpp"

namespace shigusa {

// Parts of a data set that are kept apart for training and evaluation.
enum class Split {
  train,
  validation,
  test,
  none,  // of tasks that were refused: they have no body, or no motions
};
template <>
inline constexpr std::array kEnumWords<Split>{
    EnumWord{Split::train, "train"},
    EnumWord{Split::validation, "validation"},
    EnumWord{Split::test, "test"},
    EnumWord{Split::none, "none"},
};
// Long-run percentage of people, and of regions, in each of the first three.
inline constexpr std::array<int, 3> kSplitPercent{80, 10, 10};

// Fields of a task's row that identify the person.
struct SplitPerson {
  std::uint64_t number = 0;  // of the plan's people
  std::string character{};
  std::uint8_t sex = 0;
  double stature_m = 0.0;
  double mass_kg = 0.0;
};

// Part of a person, the same in every data set: by number if the plan has people, else by
// character, sex, stature to the centimetre and mass to the kilogram, shared by similar people.
[[nodiscard]] Split split_of_person(const SplitPerson& person, bool numbered);

// Number of a goal's cell (m, world): by its height, its distance from the vertical axis through
// the body's standing point, and its direction from there.
inline constexpr double kRegionSize = 0.25;         // m, of height and distance
inline constexpr double kRegionTurnDeg = 45.0;      // of the direction
inline constexpr std::uint16_t kNoRegion = 0xFFFF;  // of a task without goals
[[nodiscard]] std::uint16_t region_of(const Vec3d& goal);

// Part of a region, the same in every data set.
[[nodiscard]] Split split_of_region(std::uint16_t region);

// Table of splits, one row per task, in the order of the tasks' table.
inline constexpr const char* kSplitsTable = "/splits";
[[nodiscard]] Table splits_table();

// Adds the rows of a shard's tasks, from tables with at least these columns: task, person, status,
// character, stature_m, mass_kg and sex; task and position_m.
void add_splits(const Table& tasks, const Table& goals, bool numbered, Table& splits);

}  // namespace shigusa
