// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/search.hpp>
#include <span>
#include <vector>

// Points stored one after the other in one vector, (count × genes), in a problem's format.
namespace shigusa {

// Point i of the points.
[[nodiscard]] std::span<const double> point_of(std::span<const double> points, std::size_t i,
                                               std::size_t genes);
void set_point(std::span<double> points, std::size_t i, std::span<const double> point);

// The indices 0..scores.size()-1, sorted by ascending score, ties by index.
[[nodiscard]] std::vector<std::size_t> ranked(std::span<const double> scores);

// Reflects a coordinate into [0, 1] at both ends; 0 if it is not finite.
[[nodiscard]] double reflected(double x);

// Merges scored points into the `keep` best, best first; ties favour earlier points.
void keep_best(std::vector<Individual>& best, std::span<const double> points,
               std::span<const double> scores, std::size_t keep);

}  // namespace shigusa
