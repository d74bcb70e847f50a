// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "layers/layer.hpp"

namespace shigusa {

// Motions that each final angle of what no goal moves takes to be found.
inline constexpr int kRestEvaluations = 40;

// Scores of motions by their final angles: `finals` is (scores × angles) rad.
using RestEvaluation = std::function<void(std::span<const double> finals, std::span<double>)>;

// The final angles with the lowest score, searched out from `finals` by CMA-ES within their genes'
// ranges; those if none is better, or where the layers have no such genes.
void search_finals(std::span<const Layer> layers, std::uint64_t seed, const RestEvaluation& score,
                   std::vector<double>& finals);

}  // namespace shigusa
