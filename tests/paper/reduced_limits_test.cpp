// SPDX-License-Identifier: MIT
#include "paper/reduced_limits.hpp"

#include <gtest/gtest.h>

#include <shigusa/request.hpp>

#include "support/layered.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(ReducedLimits, FreedomGivesWayOverTheMarginBeforeTheLimitThatItIsPulledTo) {
  const PosedBody posed = human_body();
  const Task task =
      with_preset(Task(posed, {.goals = {{"right_hand", {-0.3, 1.2, 0.4}}}}), Preset::human);
  const LayeredProblem problem = testing_support::make_layered_problem(task);
  const LayeredSetup setup(problem);
  const ReducedProblem& upper = setup.upper;
  ReducedLimits<double> limits(upper);
  ASSERT_FALSE(limits.empty());
  const std::size_t count = upper.dofs().size();
  const std::vector<double> weights(count, 2.0);
  std::vector<double> start(count);
  for (std::size_t d = 0; d < count; ++d) start[d] = upper.dofs()[d].start;
  for (const int limited : upper.limited) {
    const auto d = static_cast<std::size_t>(limited);
    const ReducedDof& dof = upper.dofs()[d];
    double margin = kLimitMargin;
    double moved = 0.0;  // of a leg's line the limits are the ankle's
    for (const ReducedLimb& limb : upper.body->limbs) {
      if (limb.lean != limited) continue;
      margin = kAnkleMargin;
      moved = BasicHingedLimb<double>(limb.joints.segments)
                  .direction_of_length(start[static_cast<std::size_t>(limb.slide)]);
    }
    for (const double pull : {1.0, -1.0, 0.0}) {
      for (const auto& [room, share] :
           {std::pair{0.25, 0.15625}, {0.5, 0.5}, {1.0, 1.0}, {1.5, 1.0}, {-0.1, 0.0}}) {
        const double within = min(room * margin, 0.99 * (dof.upper - dof.lower));
        std::vector<double> q = start;
        q[d] = moved + (pull < 0.0 ? dof.lower + within : dof.upper - within);
        std::vector<double> force(count);
        force[d] = pull;
        std::vector<double> inverse = weights;
        limits.reset(weights);
        limits.learn(force, std::vector<double>(count));
        limits.soften(q, inverse);
        EXPECT_NEAR(inverse[d], pull == 0.0 ? 2.0 : 2.0 * share, 1e-9) << dof.name << room << pull;
        limits.hold(q, inverse);
        EXPECT_EQ(inverse[d] == 0.0, room < 0.0) << dof.name << pull;
        const double kept = room < 0.0 ? 0.0 : within;
        EXPECT_NEAR(q[d] - moved, pull < 0.0 ? dof.lower + kept : dof.upper - kept, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace shigusa
