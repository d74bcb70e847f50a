// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/shigusa.hpp>

#include "body/posture_modes.hpp"
#include "generate/posture_meter.hpp"
#include "human/at_ease.hpp"

namespace shigusa {
namespace {

// The start posture with some dofs at other angles (degrees).
std::vector<double> posed(const PosedBody& posed,
                          const std::vector<std::pair<const char*, double>>& turned) {
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  for (const auto& [name, angle] : turned) {
    angles[static_cast<std::size_t>(posed.body.find_dof(name).value())] = radians(angle);
  }
  return angles;
}

std::vector<double> mode(const PosedBody& posed, const char* name, double value) {
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  for (const PostureMode& m : posture_modes(posed)) {
    if (m.name != name) continue;
    for (std::size_t d = 0; d < angles.size(); ++d) angles[d] += value * m.direction[d];
  }
  return angles;
}

int right_hand(const PosedBody& posed) {
  for (std::size_t e = 0; e < posed.body.effectors().size(); ++e) {
    if (posed.body.effectors()[e].name == "right_hand") return static_cast<int>(e);
  }
  return -1;
}

class FinalPostures : public testing::TestWithParam<const char*> {
 protected:
  const PosedBody body_ = std::string(GetParam()) == "half_body" ? half_body() : full_body();
  PostureMeter meter_{body_, body_.home, right_hand(body_)};
  [[nodiscard]] FinalPosture of(const std::vector<double>& angles) {
    return meter_.measure(angles);
  }
};

TEST_P(FinalPostures, StartIsUpright) {
  const FinalPosture posture = of(posed(body_, {}));
  EXPECT_FALSE(posture.stoop_squat_index.has_value());
  EXPECT_NEAR(posture.trunk_turn, 0.0, 1e-12);
  EXPECT_EQ(posture_words(posture), "upright");
}

TEST_P(FinalPostures, HipsThatStayAtTheirHeightAreAStoop) {
  std::vector<double> angles = posed(body_, {{"right_shoulder.flexion", 90.0}});  // hangs
  for (const char* hip : {"left_hip.flexion", "right_hip.flexion"}) {
    if (const auto dof = body_.body.find_dof(hip))
      angles[static_cast<std::size_t>(*dof)] += radians(90.0);
  }
  const FinalPosture posture = of(angles);
  EXPECT_NEAR(posture.stoop_squat_index.value(), 100.0, 1e-9);
  EXPECT_GT(posture.trunk_lean, radians(60.0));
  EXPECT_EQ(posture_words(posture), "stoop, straight knees");
}

TEST_P(FinalPostures, HipsThatSinkWithTheShouldersAreASquat) {
  const FinalPosture posture = of(mode(body_, "squat", radians(115.0)));
  EXPECT_LT(posture.stoop_squat_index.value(), 15.0);
  // an upright trunk sinks as far as its hips do
  const double sunk = of(posed(body_, {{"right_knee.flexion", 110.0},
                                       {"right_hip.flexion", 60.0},
                                       {"right_ankle.flexion", 50.0}}))
                          .stoop_squat_index.value();
  if (std::string(GetParam()) == "half_body") {
    EXPECT_NEAR(sunk, 0.0, 6.0);
  }
  EXPECT_NEAR(posture.knee_flexion, radians(115.0), 0.1);
  EXPECT_EQ(posture_words(posture), "squat");
}

TEST_P(FinalPostures, ElbowThatPointsAwayFromTheTrunkIsOut) {
  // the upper arm level to the side, the forearm forwards: the elbow is at the side of the line
  const auto out =
      posed(body_, {{"right_shoulder.abduction", 90.0}, {"right_elbow.flexion", 90.0}});
  EXPECT_GT(of(out).elbow_swivel, radians(50.0));
  // the upper arm hangs, the forearm is level: the elbow is below the line
  const auto below = posed(body_, {{"right_elbow.flexion", 90.0}});
  EXPECT_LT(std::fabs(of(below).elbow_swivel), radians(30.0));
}

INSTANTIATE_TEST_SUITE_P(Body, FinalPostures, testing::Values("half_body", "full_body"),
                         [](const auto& of) { return std::string(of.param); });

TEST(FinalPosture, StrangeIsWhatNobodyDoesWhoNeedNot) {
  EXPECT_FALSE(is_strange({}));
  FinalPosture folded;
  folded.stoop_squat_index = 100.0;
  folded.trunk_lean = radians(112.0);
  EXPECT_TRUE(is_strange(folded));
  folded.knee_flexion = radians(40.0);
  EXPECT_FALSE(is_strange(folded));
  FinalPosture crouched;  // with shoulders that stay up
  crouched.knee_flexion = radians(30.0);
  EXPECT_TRUE(is_strange(crouched));
  FinalPosture turned_in;
  turned_in.elbow_swivel = radians(-80.0);
  EXPECT_TRUE(is_strange(turned_in));
}

TEST(FinalPosture, OfOneWhoSitsHasNoWordsOfKnees) {
  const PosedBody posed = build_human(
      seated(standing_landmarks(1.7, kStandingToeOut), 1.7, 0.42),
      {.name = "s", .extent = BodyExtent::human, .stature = 1.7, .mass = 70.0, .sits = true});
  PostureMeter meter(posed, posed.home, right_hand(posed));
  const auto start = meter.measure(posed.home.angles);
  EXPECT_EQ(posture_words(start), "sitting");
  const auto bent = meter.measure(mode(posed, "lean", radians(60.0)));
  EXPECT_GT(bent.stoop_squat_index.value_or(0.0), kStoopIndex);  // hips cannot come down
  EXPECT_EQ(posture_words(bent), "sitting, leaning");
}

TEST(FinalPosture, OfHandsAboveTheKneesIsToldByTrunkAndKnees) {
  const PosedBody body = full_body();
  PostureMeter meter(body, body.home, right_hand(body));
  const auto hinge = [&](double arm) {
    return meter.measure(posed(body, {{"right_hip.flexion", 90.0},
                                      {"left_hip.flexion", 90.0},
                                      {"right_shoulder.flexion", arm}}));
  };
  EXPECT_GT(hinge(90.0).stoop_squat_index.value_or(0.0), kStoopIndex);  // it hangs
  const FinalPosture reaching = hinge(160.0);
  EXPECT_FALSE(reaching.stoop_squat_index.has_value());
  EXPECT_EQ(posture_words(reaching), "upright, leaning");
}

TEST(FinalPosture, TurnToTheLeftIsPositive) {
  const PosedBody posed = full_body();
  PostureMeter meter(posed, posed.home, right_hand(posed));
  const FinalPosture left = meter.measure(mode(posed, "twist", radians(40.0)));
  const FinalPosture right = meter.measure(mode(posed, "twist", radians(-40.0)));
  EXPECT_GT(left.trunk_turn, radians(20.0));
  EXPECT_NEAR(right.trunk_turn, -left.trunk_turn, 0.1);
  EXPECT_EQ(posture_words(left), "upright, turned left");
  EXPECT_EQ(posture_words(right), "upright, turned right");
}

}  // namespace
}  // namespace shigusa
