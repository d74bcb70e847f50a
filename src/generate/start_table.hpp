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

// One number of a start table, a coordinate of a ParameterSpace in 1/61 of its range.
inline constexpr std::string_view kStartDigits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
// The most coordinates of a row.
inline constexpr std::size_t kStartCoordinates = 31;

// A place of the right hand and the coordinates of the best motion that is known to lead there.
struct StartRow {
  std::array<std::int16_t, 3> place;        // in thousandths of the stature, see start_place
  char coordinates[kStartCoordinates + 1];  // a digit each, in the order of StartTable::names
};

// The paper's limb table for a whole body: where a search begins for goals around it. Rows are
// numbers without a body: other people reach for a place of theirs by nearly the same parameters.
struct StartTable {
  std::string_view names;  // of the coordinates, as the right hand's space has them; by spaces
  std::size_t feet;        // that its body stands on
  std::span<const StartRow> rows;
};

// The tables of the built-in bodies. Written by scripts/make_starts.
[[nodiscard]] std::span<const StartTable> start_tables();

// Where a goal is for a hand: from the shoulder in the start posture to the goal, in statures; of a
// left hand in the mirror. None for what is no hand.
[[nodiscard]] std::optional<Vec3d> start_place(const BodyModel& body, int effector,
                                               const Vec3d& goal);

// How many rows of a table a search looks at: two batches of 16 with the bent postures.
inline constexpr int kNearestStarts = 16;
// Standard deviation that a search begins with where it knows such places.
inline constexpr double kSearchStep = 0.07;

// The points (points × genes) that are upright but for each lean of the trunk with each bend of the
// knees: weights alone do not bend a knee.
[[nodiscard]] std::vector<double> bent_starts(const ParameterSpace& space);

// The points (points × genes) of the `most` rows whose places are nearest to the goals, nearest
// first, by the table that names most of the space's coordinates, of equals that of as many feet:
// the others are as in space.start(). The goals of two hands each set their arm's; what both move
// is the mean of theirs. No points where no goal is a hand's or no table serves the space.
[[nodiscard]] std::vector<double> nearest_starts(const ReachProblem& problem,
                                                 const ParameterSpace& space, int most);

// The points (points × genes) that a search begins beside: of the given motions (Task::starts), and
// after them as many of nearest_starts() as make kNearestStarts of both.
[[nodiscard]] std::vector<double> known_starts(const ReachProblem& problem,
                                               const ParameterSpace& space,
                                               std::span<const Parameters> given);

// How far a search steps along each gene (genes), beside kSearchStep: by how much the points
// (points × genes) of known_starts() differ in it, as what leads to goals near by does. Their
// mean square is 1 but for those that differ in nothing, which are kLeastScale. None for no points.
[[nodiscard]] std::vector<double> start_scales(std::span<const double> points, int genes);
inline constexpr double kLeastScale = 0.3;

}  // namespace shigusa
