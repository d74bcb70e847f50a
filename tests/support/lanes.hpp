// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "rollout/batch_rollout.hpp"
#include "rollout/rollout.hpp"

// Helpers for tests that score motions in lanes and in double.
namespace shigusa::testing_support {

// The scores of motions in double precision.
struct PlayedMotions {
  std::vector<bool> met;
  std::vector<double> scores;
  std::vector<double> ends;  // (motions × dofs) rad

  void add(const ReachProblem& problem, const Parameters& parameters,
           const CriteriaSettings& criteria) {
    const RolledOut rolled = roll_out(problem, parameters);
    met.push_back(rolled.outcome.met());
    scores.push_back(score_motion(*problem.body, rolled.motion, criteria, problem.context).total);
    const std::span<const double> end = rolled.motion.clip.frame(problem.steps);
    ends.insert(ends.end(), end.begin(), end.end());
  }
};

// Expects every SIMD set to score the motions as double does, and to end them in the same posture.
// Motions that miss in either, the minority, are left out. Accelerations are second differences of
// angles, with an error of some 2e-3 rad/s² in single precision; with an inertia of 10 kg·m² about
// an ankle of 20 N·m that is 1e-3 of its strength, and feasibility and jolts take the worst moment.
inline void expect_lanes_like(const PlayedMotions& played, const ReachProblem& problem,
                              const CriteriaSettings& criteria, const MotionInputs& inputs) {
  const std::size_t dofs = problem.body->dofs().size();
  for (const SimdSet set : usable_simd_sets()) {
    BatchRollout batch(problem, criteria, {set, 1});
    std::vector<double> scores(played.scores.size());
    std::vector<float> angles(scores.size() * dofs);
    batch.score(inputs, scores, angles);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < scores.size(); ++i) {
      if (!played.met[i] || scores[i] >= worst_score(criteria)) continue;
      ++compared;
      EXPECT_NEAR(scores[i], played.scores[i], 4e-3 * worst_score(criteria))
          << simd_name(set) << ' ' << i;
      for (std::size_t k = i * dofs; k < (i + 1) * dofs; ++k) {
        EXPECT_NEAR(static_cast<double>(angles[k]), played.ends[k], 2e-3);
      }
    }
    EXPECT_GT(compared, scores.size() * 2 / 5) << simd_name(set);
  }
}

}  // namespace shigusa::testing_support
