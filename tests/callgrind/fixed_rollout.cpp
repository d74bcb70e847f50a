// SPDX-License-Identifier: MIT
// fixed_rollout BODY HOW ROUNDS: the same 32 motions in each round, for scripts/callgrind_counts.
// BODY is half_body or full_body, HOW is double or a SIMD set.
#include <cstdio>
#include <cstdlib>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>
#include <string_view>

#include "plan/held_input.hpp"
#include "rollout/batch_rollout.hpp"
#include "rollout/rollout.hpp"
#include "support/problems.hpp"

namespace {

using namespace shigusa;

constexpr int kMotions = 32;  // full lanes in every set

int play(const PosedBody& posed, std::string_view how, int rounds) {
  const ReachProblem problem = testing_support::reach_with(posed, "right_hand", {0.25, 0.55, 0.50});
  const CriteriaSettings criteria;
  Random random(7);
  std::vector<Parameters> motions;
  std::vector<float> inverse;
  for (int i = 0; i < kMotions; ++i) {
    motions.push_back(testing_support::random_parameters(posed, random));
    for (const double weight : inverse_weights(posed, motions.back())) {
      inverse.push_back(static_cast<float>(weight));
    }
  }
  if (how == "double") {
    for (int round = 0; round < rounds; ++round) {
      for (const Parameters& parameters : motions) {
        const RolledOut rolled = roll_out(problem, parameters);
        if (!(score_motion(posed, rolled.motion, criteria).total > 0.0)) return 1;
      }
    }
    return 0;
  }
  const auto simd = find_simd(how);
  if (!simd) return 1;
  BatchRollout batch(problem, criteria, {*simd, 1});
  std::vector<double> scores(kMotions);
  for (int round = 0; round < rounds; ++round) batch.score(inverse, scores);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "fixed_rollout BODY HOW ROUNDS\n");
    return 2;
  }
  const std::string_view posed = arguments[1];
  return play(posed == "half_body" ? half_body() : full_body(), arguments[2],
              std::atoi(arguments[3]));
}
