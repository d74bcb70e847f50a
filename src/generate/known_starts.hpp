// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/parameters.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "generate/parameter_space.hpp"
#include "generate/start_table.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Rows of a table that a search scores: two batches of 16 with the bent postures.
inline constexpr int kNearestStarts = 16;
// Initial standard deviation of a search with known starts.
inline constexpr double kSearchStep = 0.07;

// Bounds of one coordinate.
struct Bound {
  int gene = 0;
  double low = 0.0;
  double high = 1.0;
};
// A part of the space, as bounds of some coordinates.
using Niche = std::vector<Bound>;

// The points (points × genes) that combine each lean of the trunk with each bend of the knees:
// weights alone do not bend a knee.
[[nodiscard]] std::vector<double> bent_starts(const ParameterSpace& space);

// The motions of a start table for tasks like a problem: of the table of the problem's kind, or of
// one with fewer circumstances; then of the one that names most of the space's coordinates, then of
// one with as many feet. Other coordinates are those of space.start(). None if no goal is a hand's,
// or no table fits the space. The tables must not be set anew meanwhile.
class KnownStarts {
 public:
  KnownStarts(const ReachProblem& problem, const ParameterSpace& space);

  // The points (points × genes) of a search: the given motions (Task::starts), then the best ones
  // of the nearest rows, nearest first, up to kNearestStarts in all.
  [[nodiscard]] std::vector<double> points(std::span<const Parameters> given = {}) const;
  // The points (points × genes), at most kNearestStarts, of the nearest rows' motions that are in a
  // part of the space.
  [[nodiscard]] std::vector<double> within(const Niche& niche) const;

 private:
  // One column of the table, or of its mirror image.
  struct Column {
    int gene = -1;          // gene that it sets; -1: none
    bool mirrored = false;  // changes its sign in the mirror
  };
  [[nodiscard]] static std::vector<Column> columns_of(const StartTable& table,
                                                      const ParameterSpace& space, bool mirror);
  [[nodiscard]] const StartTable* table_for(const ReachProblem& problem) const;
  void add(const NearRow& row, std::string_view digits, std::vector<double>& points) const;

  ParameterSpace space_;
  std::array<std::vector<Column>, 2> columns_{};  // of the table, and of its mirror image
  std::vector<NearRow> rows_{};                   // nearest first
};

// The points (points × genes) that a person with a habit of the knees begins at as well: known
// ones, which are of usual persons, with other bends of the knees. None for the usual habit.
[[nodiscard]] std::vector<double> habit_starts(const ReachProblem& problem,
                                               const ParameterSpace& space,
                                               std::span<const double> known);

// Initial step along each gene (genes), relative to kSearchStep: the spread of the points (points ×
// genes) of KnownStarts, which differ as motions to nearby goals do. Their mean square is 1
// apart from the lower bound kLeastScale. Empty without points.
[[nodiscard]] std::vector<double> start_scales(std::span<const double> points, int genes);
inline constexpr double kLeastScale = 0.3;

}  // namespace shigusa
