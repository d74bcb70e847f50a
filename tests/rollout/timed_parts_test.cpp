// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "nlp/nlp_rollout.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kLow{-0.1, 0.5, 0.5};

std::size_t part_of(const BodyModel& body, const std::string& dof) {
  return timed_parts(body)[static_cast<std::size_t>(body.find_dof(dof).value())];
}

TEST(TimeWindow, GoesFromZeroAtItsBeginToOneAtItsEnd) {
  const TimeWindow window{0.2, 0.7};
  EXPECT_NEAR(window.at(0.2), 0.0, 1e-15);
  EXPECT_NEAR(window.at(0.45), 0.5, 1e-15);
  EXPECT_NEAR(window.at(0.7), 1.0, 1e-15);
  EXPECT_LT(window.at(0.1), 0.0);
  EXPECT_GT(window.at(0.9), 1.0);
  EXPECT_EQ(TimeWindow{}.at(0.3), 0.3);
}

TEST(TimedParts, AreThoseOfTheJoints) {
  const BodyModel body = human_body();
  const auto number = [](TimedPart part) { return static_cast<std::size_t>(part); };
  EXPECT_EQ(part_of(body, "left_knee.flexion"), number(TimedPart::knees));
  EXPECT_EQ(part_of(body, "right_hip.abduction"), number(TimedPart::hips));
  for (const char* back : {"spine.flexion", "chest.lateral", "upper_chest.rotation"}) {
    EXPECT_EQ(part_of(body, back), number(TimedPart::spine)) << back;
  }
  for (const char* rest : {"left_shoulder.flexion", "right_elbow.flexion", "right_wrist.deviation",
                           "left_clavicle.elevation", "neck.flexion"}) {
    EXPECT_EQ(part_of(body, rest), number(TimedPart::arms)) << rest;
  }
}

TEST(TimedParts, AreTheSameOnBothSides) {
  const BodyModel body = human_body({.heels = true});
  const std::vector<std::size_t> parts = timed_parts(body);
  ASSERT_EQ(parts.size(), body.dofs().size());
  for (std::size_t d = 0; d < parts.size(); ++d) {
    EXPECT_LT(parts[d], kTimedParts);
    std::string name = body.dofs()[d].name;
    if (!name.starts_with("left_")) continue;
    EXPECT_EQ(part_of(body, "right_" + name.substr(5)), parts[d]) << name;
  }
}

// The knee is drawn in the second half of the time: until then both rollouts move as without a
// change.
TEST(TimeWindow, KeepsItsPartBackUntilItBegins) {
  ReachProblem problem = reach_with(half(), "right_hand", kLow);
  for (TimeWindow& window : problem.windows) window = {0.5, 1.0};
  const std::vector<double> weights(half().body.dofs().size(), 1.0);
  const std::vector<double> none(weights.size(), 0.0);
  std::vector<double> change = none;
  const auto knee = static_cast<std::size_t>(half().body.find_dof("right_knee.flexion").value());
  change[knee] = 0.5;
  const auto knees = [&](auto& rollout, std::span<const double> posture) {
    std::vector<double> angles;
    rollout.run(MotionInput<double>(weights, posture, {}),
                [&](const PlacedFrame<double>& frame) { angles.push_back(frame.angles[knee]); });
    return angles;
  };
  const auto compare = [&](auto& rollout) {
    const std::vector<double> plain = knees(rollout, none);
    const std::vector<double> drawn = knees(rollout, change);
    for (std::size_t f = 0; f <= 30; ++f) EXPECT_NEAR(drawn[f], plain[f], 1e-12) << f;
    EXPECT_GT(drawn[60], plain[60] + 0.1);
  };
  Rollout<double> rollout(problem);
  NlpRollout nlp_rollout(problem);
  compare(rollout);
  compare(nlp_rollout);
}

}  // namespace
}  // namespace shigusa
