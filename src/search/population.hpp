// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/search.hpp>
#include <span>
#include <vector>

// Points one after the other in one vector, (count × genes), as a problem takes them.
namespace shigusa {

// Point i of them.
[[nodiscard]] std::span<const double> point_of(std::span<const double> points, std::size_t i,
                                               std::size_t genes);
void set_point(std::span<double> points, std::size_t i, std::span<const double> point);

// The indices 0..scores.size()-1, the lowest score first, equal ones by index.
[[nodiscard]] std::vector<std::size_t> ranked(std::span<const double> scores);

// Brings a coordinate back into [0, 1] by mirrors at both ends; 0 for what is not finite.
[[nodiscard]] double reflected(double x);

// Merges scored points into the `keep` best, the best first; among equals those known before.
void keep_best(std::vector<Individual>& best, std::span<const double> points,
               std::span<const double> scores, std::size_t keep);

}  // namespace shigusa
