// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "dynamics/clip_dynamics.hpp"
#include "human/landmark_points.hpp"
#include "motion/minimum_jerk.hpp"
#include "support/motions.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// Measures of a motion without any demand.
MotionMeasures nothing_of(const PosedBody& posed) {
  MotionMeasures measures;
  for (int d = 0; d < posed.body.dof_count(); ++d) measures.loads.push_back({.dof = d});
  measures.support = SupportMargins{{0.1, 0.0}, {0.1, 0.0}};
  return measures;
}

MotionMeasures loaded(const PosedBody& posed, double share) {
  MotionMeasures measures = nothing_of(posed);
  const double torque = share * posed.body.dof(2).torque_positive;
  measures.loads[2] = {.dof = 2, .torque = torque, .share = share, .time = 0.25};
  return measures;
}

Verdict verdict_on(const MotionMeasures& measures) { return judge(full_body(), measures).verdict; }

TEST(Verdict, WhatAsksForNothingIsPossible) {
  const PosedBody posed = full_body();
  const Judgement judgement = judge(posed, nothing_of(posed));
  EXPECT_EQ(judgement.verdict, Verdict::possible);
  EXPECT_TRUE(judgement.reasons.empty());
}

TEST(Verdict, GoesByTheShareOfStrength) {
  const PosedBody posed = full_body();
  EXPECT_EQ(verdict_on(loaded(posed, 1.01)), Verdict::possible);
  EXPECT_EQ(verdict_on(loaded(posed, 1.03)), Verdict::strains);
  EXPECT_EQ(verdict_on(loaded(posed, 1.49)), Verdict::strains);
  EXPECT_EQ(verdict_on(loaded(posed, 1.51)), Verdict::impossible);
}

TEST(Verdict, GoesByHowFarThePressureLeavesTheFeet) {
  MotionMeasures measures = nothing_of(full_body());
  const auto outside = [&](double distance) {
    measures.support->pressure = {-distance, 0.3};
    return verdict_on(measures);
  };
  EXPECT_EQ(outside(0.009), Verdict::possible);
  EXPECT_EQ(outside(0.011), Verdict::strains);
  EXPECT_EQ(outside(0.051), Verdict::impossible);
  measures.support.reset();
  EXPECT_EQ(verdict_on(measures), Verdict::possible);
}

TEST(Verdict, GoesByTheDepthOfACollision) {
  MotionMeasures measures = nothing_of(full_body());
  const auto deep = [&](double depth, bool hard = false) {
    measures.collides = {depth, "right_forearm", hard ? "shelf" : "head", 0.4, hard};
    return verdict_on(measures);
  };
  EXPECT_EQ(deep(0.004), Verdict::possible);
  EXPECT_EQ(deep(0.006), Verdict::strains);
  EXPECT_EQ(deep(0.021), Verdict::impossible);
  EXPECT_EQ(deep(0.009, true), Verdict::strains) << "of a hard thing only the body yields";
  EXPECT_EQ(deep(0.011, true), Verdict::impossible);
}

TEST(Verdict, GoesByHowFarAJointIsBeyondItsRange) {
  MotionMeasures measures = nothing_of(full_body());
  const auto beyond = [&](double angle) {
    measures.over_limit = {{"right_knee.flexion", radians(angle)}};
    return verdict_on(measures);
  };
  EXPECT_EQ(beyond(2.9), Verdict::possible);
  EXPECT_EQ(beyond(3.1), Verdict::strains);
  EXPECT_EQ(beyond(10.1), Verdict::impossible);
}

TEST(Verdict, DrivesOfARobotGiveNoMoreThanItsFileSays) {
  BodyDefinition definition = full_body().body.definition();
  definition.robot = true;
  const PosedBody robot{BodyModel(definition), full_body().home};
  EXPECT_EQ(judge(robot, loaded(robot, 0.99)).verdict, Verdict::possible);
  EXPECT_EQ(judge(robot, loaded(robot, 1.01)).verdict, Verdict::impossible);
}

TEST(Verdict, IsThatOfTheWorstReasonWhichComesFirst) {
  const PosedBody posed = full_body();
  MotionMeasures measures = loaded(posed, 1.2);
  measures.collides = {0.08, "right_forearm", "head", 0.4};
  measures.over_limit = {{"left_knee.flexion", radians(20.0)}};
  const Judgement judgement = judge(posed, measures);
  EXPECT_EQ(judgement.verdict, Verdict::impossible);
  ASSERT_EQ(judgement.reasons.size(), 3u);
  EXPECT_EQ(judgement.reasons[0].kind, ReasonKind::collision);  // 4 times the bound of impossible
  EXPECT_EQ(judgement.reasons[1].kind, ReasonKind::limit);      // 2 times
  EXPECT_EQ(judgement.reasons[2].kind, ReasonKind::strength);
  EXPECT_EQ(judgement.reasons[2].verdict, Verdict::strains);
}

TEST(Verdict, ReasonsSayJointNumberAndTime) {
  const PosedBody posed = full_body();
  MotionMeasures measures = loaded(posed, 2.0);
  measures.support->pressure = {-0.353, 0.61};
  measures.collides = {0.042, "right_forearm", "head", 0.4};
  measures.over_limit = {{"left_knee.flexion", radians(12.0)}};
  std::string words;
  for (const Reason& reason : judge(posed, measures).reasons) words += reason_words(reason) + "\n";
  EXPECT_THAT(words, HasSubstr(posed.body.dof(2).name + " needs "));
  EXPECT_THAT(words, HasSubstr("at 0.25 s, 2.0 times its strength of "));
  EXPECT_THAT(words, HasSubstr("the floor would have to press 353 mm outside the feet at 0.61 s"));
  EXPECT_THAT(words, HasSubstr("right_forearm is 42 mm in head at 0.40 s"));
  EXPECT_THAT(words, HasSubstr("left_knee.flexion is 12° beyond its range"));
}

// A mass of 1 kg on a rod of 1 m that swings up from hanging sideways, within its strength if there
// is enough time.
struct Swing {
  static PosedBody body(double strength) {
    BodyDefinition chain = chain_definition({{Axis::x, 1.0, 1.0}});
    chain.dofs[0].torque_positive = chain.dofs[0].torque_negative = strength;
    return at_zero(chain);
  }
  static Motion motion(const PosedBody& posed, double duration) {
    std::vector<std::vector<double>> frames;
    constexpr int kSteps = 60;
    for (int f = 0; f <= kSteps; ++f) {
      frames.push_back({1.0 - minimum_jerk(static_cast<double>(f) / kSteps)});
    }
    Clip clip = motion_through(posed, frames).clip;
    clip.frame_time = duration / kSteps;
    return ClipDynamics(posed).completed(clip);
  }
};

TEST(Verdict, TellsTheDurationInWhichAHastyMotionIsPossible) {
  const PosedBody posed = Swing::body(16.0);
  const Motion hasty = Swing::motion(posed, 0.3);
  const Judgement judgement = judge(posed, hasty, measure_motion(posed, hasty, {}));
  ASSERT_EQ(judgement.verdict, Verdict::impossible);
  ASSERT_TRUE(judgement.possible_in);
  EXPECT_GT(*judgement.possible_in, 0.3);
  const auto in = [&](double duration) {
    const Motion motion = Swing::motion(posed, duration);
    return judge(posed, measure_motion(posed, motion, {})).verdict;
  };
  EXPECT_EQ(in(*judgement.possible_in), Verdict::possible);
  // six halvings of the range up to three times the duration
  EXPECT_NE(in(*judgement.possible_in - 2.0 * 0.3 / 64.0 - 1e-9), Verdict::possible);
}

TEST(Verdict, NoTimeMakesWhatIsTooHeavyPossible) {
  const PosedBody posed = Swing::body(4.0);  // of some 8 N·m that the mass takes at the start
  const Motion motion = Swing::motion(posed, 1.0);
  const Judgement judgement = judge(posed, motion, measure_motion(posed, motion, {}));
  EXPECT_EQ(judgement.verdict, Verdict::impossible);
  EXPECT_FALSE(judgement.possible_in);
}

TEST(JudgeStart, OfWhoLeansBesideTheFeetIsImpossibleWhateverTheGoal) {
  Landmarks leaning = standing_landmarks(1.7, kStandingToeOut);
  const auto judged = [&leaning] {
    const PosedBody posed = build_human(leaning, {.stature = 1.7});
    return judge_start(posed, posed.home);
  };
  EXPECT_EQ(judged().verdict, Verdict::possible);
  for_each_point(leaning, [](Vec3d& p) { p.z += p.y > 0.1 ? 0.3 * p.y : 0.0; });
  const Judgement judgement = judged();
  EXPECT_EQ(judgement.verdict, Verdict::impossible);
  for (const Reason& reason : judgement.reasons) EXPECT_FALSE(reason.time);
}

}  // namespace
}  // namespace shigusa
