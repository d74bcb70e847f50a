// SPDX-License-Identifier: MIT
#include "pack_scorer.hpp"

namespace shigusa {

std::unique_ptr<LaneScorer> make_lanes_4_scorer(const ReachProblem& problem,
                                                const CriteriaSettings& criteria) {
  return std::make_unique<PackScorer<4>>(problem, criteria);
}

}  // namespace shigusa
