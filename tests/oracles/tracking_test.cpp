// SPDX-License-Identifier: MIT
// Generated motions played by MuJoCo's forward simulation (support/tracking.hpp).
#include "support/tracking.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr int kGoals = 100;

// Goals within reach of either posture, bent to the floor or stretched.
Vec3d any_goal(Random& random) {
  return {random.uniform(-0.7, 0.5), random.uniform(0.1, 1.9), random.uniform(0.1, 0.8)};
}

TEST(Tracking, EightOfAHundredMotionsFallAtMost) {
  const PosedBody posed = human_body();
  Tracking tracking(posed);
  Random random(17);
  int played = 0;
  int fallen = 0;
  for (std::uint64_t seed = 1; played < kGoals; ++seed) {
    Task task(posed);
    task.goals = {{"right_hand", any_goal(random)}};
    task.seed = seed;
    const GenerateResult generation = generate(task).value();
    if (!generation.meets_goals()) continue;
    ++played;
    fallen += tracking.run(generation.candidates[0].motion) > kFallen ? 1 : 0;
  }
  RecordProperty("fallen", fallen);
  EXPECT_LE(fallen, 8 * kGoals / 100);
}

}  // namespace
}  // namespace shigusa
