// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "rules.hpp"

namespace shigusa::bench {

// Compliance of a mixture's best motions with one rule.
struct RuleResult {
  int terms = 0;
  int held = 0;        // terms within the band
  double value = 0.0;  // mean of the figure
  double loss = 0.0;   // mean of loss_of
};

// Results of all rules, and their mean loss. Rules have equal weights, except those with few terms.
struct Measured {
  std::vector<RuleResult> rules;  // (rule_names())
  double loss = 0.0;
  double jolting = 0.0;  // share of the motions that jolt
};

struct MeasureSettings {
  int threads = 0;
  std::uint64_t seed = 0;        // of the queries
  std::optional<int> motions{};  // scored per query; default if empty
};

// (mixtures × cases) figures of the best motion.
[[nodiscard]] std::vector<Figures> best_figures(std::span<const Unit* const> units,
                                                std::span<const CriteriaSettings> mixtures,
                                                const MeasureSettings& settings);

// Compliance of these with people's rules. Sums are ordered, so that the result is the same for any
// number of threads.
[[nodiscard]] std::vector<Measured> measure(std::span<const Unit* const> units,
                                            std::span<const CriteriaSettings> mixtures,
                                            const MeasureSettings& settings);

// Units of the training set, or of the held-out set.
[[nodiscard]] std::vector<const Unit*> part_of(const std::vector<Unit>& units, bool held_out);

}  // namespace shigusa::bench
