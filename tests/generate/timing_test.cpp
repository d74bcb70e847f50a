// SPDX-License-Identifier: MIT
// A task's ease and gaze lead change the timing, but neither positions nor postures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

namespace shigusa {
namespace {

using testing::HasSubstr;

// A reach to the left, without a search.
Candidate reach(double ease, double gaze_lead) {
  Task task(human_body(), {.goals = {{"right_hand", {0.3, 1.0, 0.4}}},
                           .duration = 1.2,
                           .ease = ease,
                           .gaze_lead = gaze_lead});
  return regenerate(task, uniform_parameters(task.body)).value().candidates.at(0);
}

double share_done(const Candidate& candidate, int frame) {
  const std::vector<Vec3d>& hand = candidate.motion.effectors.at(0);
  return norm(hand[static_cast<std::size_t>(frame)] - hand.front()) /
         norm(hand.back() - hand.front());
}

double angle(const Candidate& candidate, const std::string& dof, int frame) {
  static const BodyModel body = human_body();
  return candidate.motion.clip.frame(frame)[static_cast<std::size_t>(body.find_dof(dof).value())];
}

TEST(Ease, HandIsAheadOrBehindHalfWayAndMeetsItsGoalAtTheEnd) {
  const Candidate plain = reach(0.0, 0.0);
  const Candidate early = reach(kEaseMax, 0.0);
  const Candidate late = reach(-kEaseMax, 0.0);
  const int half = plain.motion.clip.frames / 2;
  EXPECT_GT(share_done(early, half), share_done(plain, half) + 0.15);
  EXPECT_LT(share_done(late, half), share_done(plain, half) - 0.15);
  for (const Candidate* each : {&plain, &early, &late}) {
    EXPECT_LE(each->goals.at(0).error, 1e-3);
    EXPECT_EQ(each->motion.clip.frames, plain.motion.clip.frames);
    // never back
    for (int f = 1; f < each->motion.clip.frames; ++f) {
      EXPECT_GE(share_done(*each, f), share_done(*each, f - 1) - 1e-4);
    }
  }
}

TEST(GazeLead, HeadTurnsEarlierOrLaterAndTheHandDoesNot) {
  const Candidate plain = reach(0.0, 0.0);
  const Candidate early = reach(0.0, kGazeLeadMost);
  const Candidate late = reach(0.0, kGazeLeadLeast);
  const int quarter = plain.motion.clip.frames / 4;
  const double usual = angle(plain, "neck.rotation", quarter);
  EXPECT_GT(usual, 0.0);
  EXPECT_GT(angle(early, "neck.rotation", quarter), 1.5 * usual);
  EXPECT_LT(angle(late, "neck.rotation", quarter), 0.5 * usual);
  EXPECT_NEAR(share_done(early, quarter), share_done(plain, quarter), 1e-3);
}

TEST(Timing, WhatIsOutsideOrOfAnotherPresetIsRefused) {
  const auto refusal = [](double ease, double gaze_lead, Preset preset) {
    Task task = with_preset(
        Task(human_body(),
             {.goals = {{"right_hand", {0.3, 1.0, 0.4}}}, .ease = ease, .gaze_lead = gaze_lead}),
        preset);
    const auto checked = PreparedTask::of(task);
    return checked ? "" : checked.error().to_string();
  };
  EXPECT_EQ(refusal(0.5, 0.2, Preset::flat), "");
  EXPECT_EQ(refusal(0.0, 0.2, Preset::human), "");
  EXPECT_THAT(refusal(0.9, 0.0, Preset::flat), HasSubstr("ease is 0.9; allowed are -0.8 to 0.8"));
  EXPECT_THAT(refusal(0.0, 0.4, Preset::flat), HasSubstr("-0.45 to 0.35 of the duration"));
  EXPECT_THAT(refusal(0.5, 0.0, Preset::human), HasSubstr("the preset human has layers"));
  EXPECT_THAT(refusal(0.0, 0.2, Preset::paper),
              HasSubstr("the preset paper does not turn the head"));
}

}  // namespace
}  // namespace shigusa
