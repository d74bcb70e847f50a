// SPDX-License-Identifier: MIT
// Scores motions of all built-in bodies in four lanes and one, with the criteria of the paper and
// with limits held and the default criteria, and writes each score's bytes; for
// scripts/check_aarch64_bytes.
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "rollout/batch_rollout.hpp"
#include "rollout/reach_problem.hpp"
#include "support/bodies.hpp"

namespace {

using namespace shigusa;

constexpr int kMotions = 16;

void score(const char* name, const PosedBody& posed, bool natural) {
  ReachProblem problem;
  problem.body = &posed.body;
  problem.context.start = posed.home;
  const Vec3d from = testing_support::effector_position(posed, posed.home.angles, "right_hand");
  problem.goals.push_back(
      {posed.body.find_effector("right_hand").value(), {from, {0.25, 0.55, 0.50}}});
  problem.hold_limits = problem.posture_law = natural;
  problem.corrections = natural ? 2 : 0;
  const CriteriaSettings criteria = natural ? default_criteria() : paper_criteria();
  Random random(7);
  std::vector<float> weights;
  for (int i = 0; i < kMotions * posed.body.dof_count(); ++i) {
    weights.push_back(1.0F / static_cast<float>(1 + random.below(15)));
  }
  for (const SimdSet simd : {SimdSet::lanes_4, SimdSet::scalar}) {
    BatchRollout batch(problem, criteria, {simd, 1});
    std::vector<double> scores(kMotions);
    std::vector<float> angles(weights.size());
    batch.score(weights, scores, angles);
    std::printf("%s %s %s", name, natural ? "natural" : "paper",
                simd == SimdSet::scalar ? "scalar" : "lanes_4");
    for (const double s : scores) std::printf(" %016" PRIx64, std::bit_cast<std::uint64_t>(s));
    std::printf(" ends");
    for (const float a : angles) std::printf(" %08" PRIx32, std::bit_cast<std::uint32_t>(a));
    std::printf("\n");
  }
}

}  // namespace

int main() {
  for (const bool natural : {false, true}) {
    score("half_body", half_body(), natural);
    score("full_body", full_body(), natural);
    score("human", human_body(), natural);
  }
}
