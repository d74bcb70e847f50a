// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "rules.hpp"

namespace shigusa::bench {

// How a mixture's best motions obey one rule.
struct RuleResult {
  int terms = 0;
  int held = 0;        // terms within the band
  double value = 0.0;  // mean of the figure
  double loss = 0.0;   // mean of loss_of
};

// The results of all rules, and their mean loss: rules count alike, whether they are about some
// tasks or about all, but for those about a few only.
struct Measured {
  std::vector<RuleResult> rules;  // (rule_names())
  double loss = 0.0;
  double jolting = 0.0;  // share of the motions that jolt
};

struct MeasureSettings {
  int threads = 0;
  std::uint64_t seed = 0;        // of the queries
  std::optional<int> motions{};  // that a query scores; as many as usual where not given
};

// (mixtures × cases) The figures of the best motion of each case by each mixture.
[[nodiscard]] std::vector<Figures> best_figures(std::span<const Unit* const> units,
                                                std::span<const CriteriaSettings> mixtures,
                                                const MeasureSettings& settings);

// How these obey people's rules. Sums are made in order, so that the result is the
// same for any number of threads.
[[nodiscard]] std::vector<Measured> measure(std::span<const Unit* const> units,
                                            std::span<const CriteriaSettings> mixtures,
                                            const MeasureSettings& settings);

// The units of the training, or those held out.
[[nodiscard]] std::vector<const Unit*> part_of(const std::vector<Unit>& units, bool held_out);

}  // namespace shigusa::bench
