// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <string>

#include "table.hpp"

namespace shigusa {

// The parts of a data set that are kept apart, to learn from one and to judge by another.
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
// The percentage of people, and of regions, that each of the first three has in the long run.
inline constexpr std::array<int, 3> kSplitPercent{80, 10, 10};

// The facts of a task's row that tell who moves.
struct SplitPerson {
  std::uint64_t number = 0;  // of the plan's people
  std::string character{};
  std::uint8_t sex = 0;
  double stature_m = 0.0;
  double mass_kg = 0.0;
};

// The part that a person belongs to, in every data set: by the number where the plan has people,
// and else by character, sex, stature to the centimetre and mass to the kilogram, which people who
// look alike have in common.
[[nodiscard]] Split split_of_person(const SplitPerson& person, bool numbered);

// The number of the cell that a goal (m, world) is in: of its height, of its distance from the
// vertical line through where the body stands, and of its direction from there.
inline constexpr double kRegionSize = 0.25;         // m, of height and distance
inline constexpr double kRegionTurnDeg = 45.0;      // of the direction
inline constexpr std::uint16_t kNoRegion = 0xFFFF;  // of a task without goals
[[nodiscard]] std::uint16_t region_of(const Vec3d& goal);

// The part that a region belongs to, in every data set.
[[nodiscard]] Split split_of_region(std::uint16_t region);

// The table of splits, one row a task, in the order of the tasks' table.
inline constexpr const char* kSplitsTable = "/splits";
[[nodiscard]] Table splits_table();

// Adds the rows of a shard's tasks, of which these tables have all columns that are needed: task,
// person, status, character, stature_m, mass_kg and sex; task and position_m.
void add_splits(const Table& tasks, const Table& goals, bool numbered, Table& splits);

}  // namespace shigusa
