// SPDX-License-Identifier: MIT
#include "splits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>
#include <vector>

#include "core/hash.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

// Number of cells below the floor.
constexpr int kCellsBelow = 16;
constexpr int kCells = 64;  // of heights, and of distances
constexpr int kDirections = static_cast<int>(360.0 / kRegionTurnDeg);

int cell_of(double length) {
  return static_cast<int>(clamp(std::floor(length / kRegionSize), -1.0 * kCells, 1.0 * kCells));
}

// Part by a number drawn for `key`.
Split split_of(std::string_view name, std::uint64_t key) {
  Fnv1a stream;
  stream.add(name);
  const std::uint32_t percent = Random(key, stream.value()).below(100);
  std::uint32_t end = 0;
  for (std::size_t k = 0; k < kSplitPercent.size(); ++k) {
    end += static_cast<std::uint32_t>(kSplitPercent[k]);
    if (percent < end) return static_cast<Split>(k);
  }
  return Split::test;
}

// Rounded to a whole number of units, so that the last bit cannot split one person in two.
std::uint64_t rounded(double value) {
  return static_cast<std::uint64_t>(clamp(nearest_integer(value), 0.0, 1e9));
}

}  // namespace

Split split_of_person(const SplitPerson& person, bool numbered) {
  if (numbered) return split_of("person", person.number);
  Fnv1a key;
  key.add(person.character);
  key.add(std::uint64_t{person.sex});
  key.add(rounded(person.stature_m * 100.0));
  key.add(rounded(person.mass_kg));
  return split_of("person", key.value());
}

std::uint16_t region_of(const Vec3d& goal) {
  if (!is_finite(goal.x) || !is_finite(goal.y) || !is_finite(goal.z)) return kNoRegion;
  const int height = std::clamp(cell_of(goal.y) + kCellsBelow, 0, kCells - 1);
  const double away = sqrt(goal.x * goal.x + goal.z * goal.z);
  const int distance = std::min(cell_of(away), kCells - 1);
  const double turn_deg = degrees(atan2(goal.x, goal.z));
  const int direction =
      (static_cast<int>(nearest_integer(turn_deg / kRegionTurnDeg)) + kDirections) % kDirections;
  return static_cast<std::uint16_t>((height * kCells + distance) * kDirections + direction);
}

Split split_of_region(std::uint16_t region) {
  return region == kNoRegion ? Split::none : split_of("region", region);
}

Table splits_table() {
  const std::string cell = fmt::format(
      "cell of the first goal: direction + {} (distance + {} (height + {})); height "
      "and horizontal distance in steps of {} m, direction in steps of {:.0f} degrees, "
      "from where the body faces to its left; {} without a goal",
      kDirections, kCells, kCellsBelow, kRegionSize, kRegionTurnDeg, kNoRegion);
  return {kSplitsTable,
          {{.name = "task", .type = ElementType::u64, .says = "number of the task"},
           {.name = "by_person",
            .type = ElementType::u8,
            .says = "a person is in one part alone",
            .words = all_words<Split>()},
           {.name = "by_region",
            .type = ElementType::u8,
            .says = "a region is in one part alone",
            .words = all_words<Split>()},
           {.name = "region", .type = ElementType::u16, .says = cell}}};
}

void add_splits(const Table& tasks, const Table& goals, bool numbered, Table& splits) {
  const auto goal_tasks = goals.find("task")->as<std::uint64_t>();
  const auto places = goals.find("position_m")->as<double>();
  std::map<std::uint64_t, std::uint16_t> regions;
  for (std::size_t k = 0; k < goal_tasks.size(); ++k) {
    // only the first goal of a task counts
    regions.emplace(goal_tasks[k],
                    region_of({places[3 * k], places[3 * k + 1], places[3 * k + 2]}));
  }
  const auto numbers = tasks.find("task")->as<std::uint64_t>();
  const auto people = tasks.find("person")->as<std::uint64_t>();
  const auto status = tasks.find("status")->as<std::uint8_t>();
  const auto sexes = tasks.find("sex")->as<std::uint8_t>();
  const auto statures = tasks.find("stature_m")->as<double>();
  const auto masses = tasks.find("mass_kg")->as<double>();
  const std::vector<std::string> characters = tasks.find("character")->texts();
  const std::vector<std::string>& words = tasks.find("status")->words;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const bool refused = status[k] < words.size() && words[status[k]] == kRefused;
    const auto found = regions.find(numbers[k]);
    const std::uint16_t region = found == regions.end() ? kNoRegion : found->second;
    const SplitPerson person{people[k], characters[k], sexes[k], statures[k], masses[k]};
    const Split by_person = refused ? Split::none : split_of_person(person, numbered);
    const Split by_region = refused ? Split::none : split_of_region(region);
    splits["task"].push_as(numbers[k]);
    splits["by_person"].push_as(static_cast<std::uint8_t>(by_person));
    splits["by_region"].push_as(static_cast<std::uint8_t>(by_region));
    splits["region"].push_as(region);
  }
}

}  // namespace shigusa
