// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <shigusa/parameters.hpp>
#include <span>

#include "paper/arm_motion.hpp"

namespace shigusa {

// The paper's code of an arm: weights 1..15, 0 for locked.
using ArmGenes = std::array<std::uint8_t, kArmDofs>;
[[nodiscard]] ArmWeights arm_weights(const ArmGenes& genes);

// The initial codes of LimbSearch::ladder.
inline constexpr std::array<std::uint8_t, 5> kLimbLadder{0, 1, 3, 7, 15};

// Scores (genomes); lower is better.
using ArmEvaluation =
    std::function<void(std::span<const ArmGenes> genomes, std::span<double> scores)>;

struct FoundArm {
  ArmGenes genes{};
  double score = 0.0;
};

// The genome with the lowest score, the first among equals; none if no score is below `worst`.
[[nodiscard]] std::optional<FoundArm> search_arm(LimbSearch search, double worst,
                                                 const ArmEvaluation& evaluate);

}  // namespace shigusa
