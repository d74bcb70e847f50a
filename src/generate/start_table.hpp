// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <shigusa/math.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "generate/parameter_space.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Digits of a start table: a coordinate of a ParameterSpace in 1/61 of its range.
inline constexpr std::string_view kStartDigits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
// Largest number of coordinates in a row.
inline constexpr std::size_t kStartCoordinates = 31;

// A position of the right hand and the coordinates of the best known motion to it.
struct StartRow {
  std::array<std::int16_t, 3> place;        // in thousandths of the stature, see start_place
  char coordinates[kStartCoordinates + 1];  // one digit each, in the order of StartTable::names
};

// The paper's limb table for a whole body: start points of a search by the position of the goal.
// Rows do not depend on the body: nearly the same parameters serve other people for positions
// relative to their size.
struct StartTable {
  std::string_view names;  // names of the right hand's coordinates, separated by spaces
  std::size_t feet;        // feet on which its body stands
  std::span<const StartRow> rows;
};

// The tables of the built-in bodies. Written by scripts/make_starts.
[[nodiscard]] std::span<const StartTable> start_tables();

// Goal position relative to the shoulder of the body at home, in statures; mirrored for a left
// hand. None for effectors other than hands.
[[nodiscard]] std::optional<Vec3d> start_place(const BodyModel& body, const State& home,
                                               int effector, const Vec3d& goal);

// Rows of a table that a search scores: two batches of 16 with the bent postures.
inline constexpr int kNearestStarts = 16;
// Initial standard deviation of a search with known starts.
inline constexpr double kSearchStep = 0.07;

// The points (points × genes) that combine each lean of the trunk with each bend of the knees:
// weights alone do not bend a knee.
[[nodiscard]] std::vector<double> bent_starts(const ParameterSpace& space);

// The points (points × genes) of the `most` rows nearest to the goals, nearest first, from the
// table that names most of the space's coordinates, then one with as many feet; other coordinates
// are those of space.start(). The goals of two hands each set their arm's coordinates; shared
// coordinates are averaged. No points if no goal is a hand's or no table fits the space.
[[nodiscard]] std::vector<double> nearest_starts(const ReachProblem& problem,
                                                 const ParameterSpace& space, int most);

// The start points (points × genes) of a search: the given motions (Task::starts), then
// nearest_starts() up to kNearestStarts in all.
[[nodiscard]] std::vector<double> known_starts(const ReachProblem& problem,
                                               const ParameterSpace& space,
                                               std::span<const Parameters> given);

// The points (points × genes) that a person with a habit of the knees begins at as well: known
// ones, which are of usual persons, with other bends of the knees. None for the usual habit.
[[nodiscard]] std::vector<double> habit_starts(const ReachProblem& problem,
                                               const ParameterSpace& space,
                                               std::span<const double> known);

// Initial step along each gene (genes), relative to kSearchStep: the spread of the points (points ×
// genes) of known_starts(), which differ as motions to nearby goals do. Their mean square is 1
// apart from the lower bound kLeastScale. Empty without points.
[[nodiscard]] std::vector<double> start_scales(std::span<const double> points, int genes);
inline constexpr double kLeastScale = 0.3;

}  // namespace shigusa
