// SPDX-License-Identifier: MIT
// Pieces of work that were written, read again and scored.
#include <gtest/gtest.h>

#include <shigusa/files.hpp>
#include <shigusa/score.hpp>

#include "support/work.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

const Candidate& candidate() { return box_work().generation.candidates.front(); }

RecordedMotion recorded_as(FileFormat format, const char* name) {
  const std::string bytes =
      export_candidate(box_work().file.character, box_work().task, candidate(), format).value();
  return parse_recorded(bytes, name, box_work().file.character, 0).value();
}

void expect_like(const WorkScore& score, double seconds) {
  const auto& own = candidate().actions;
  ASSERT_EQ(score.actions.size(), own.size());
  for (std::size_t k = 0; k < own.size(); ++k) {
    const ActionResult& action = score.actions[k].result;
    EXPECT_EQ(action.kind, own[k].kind);
    EXPECT_NEAR(action.start, own[k].start, seconds) << k;
    EXPECT_NEAR(action.end, own[k].end, seconds) << k;
    EXPECT_NEAR(action.score.total, own[k].score.total, 0.4 * own[k].score.total + 0.1) << k;
  }
  EXPECT_EQ(score.actions[0].hands.size(), 2U);
  ASSERT_EQ(candidate().hands.size(), 2U);
  EXPECT_NEAR(score.actions[0].taken.value(), candidate().hands[0].there, 0.15);
  for (const HandAtThing& hand : score.actions[0].hands) {
    EXPECT_GT(hand.distance, 0.0);
    EXPECT_LT(hand.distance, 0.04);
  }
  ASSERT_TRUE(score.actions[1].result.placed);
  EXPECT_LT(score.actions[1].result.placed->error, 0.005);
  EXPECT_LT(score.actions[1].result.placed->turn_error, radians(2.0));
}

TEST(WorkScore, TimesOfAGlbAreItsOwnAndThingsFollowTheHands) {
  const RecordedMotion recorded = recorded_as(FileFormat::glb, "work.glb");
  ASSERT_EQ(recorded.actions.size(), 2U);
  const WorkScore score = score_work(recorded, box_work().task).value();
  EXPECT_TRUE(score.doubts.empty()) << score.doubts.front().text;
  expect_like(score, 0.02);
}

TEST(WorkScore, TimesOfABvhAreFoundFromTheMotion) {
  const RecordedMotion recorded = recorded_as(FileFormat::bvh, "work.bvh");
  EXPECT_TRUE(recorded.actions.empty());
  const WorkScore score = score_work(recorded, box_work().task).value();
  ASSERT_EQ(score.doubts.size(), 1U);
  EXPECT_EQ(score.doubts.front().key, "times_found");
  // a lift ends later than the thing is clear
  expect_like(score, 0.4);
}

// The load counts while it is held, and a place that was missed is told.
TEST(WorkScore, MassesCountAndMissesAreTold) {
  const RecordedMotion recorded = recorded_as(FileFormat::glb, "work.glb");
  Task heavy = box_work().task;
  heavy.things[0].mass = 40.0;
  heavy.actions[1].position->y -= 0.2;
  const WorkScore score = score_work(recorded, heavy).value();
  EXPECT_EQ(score.judgement.verdict, Verdict::impossible);
  EXPECT_NEAR(score.actions[1].result.placed->error, 0.2, 0.01);
}

TEST(WorkScore, WrongActionsAreRefused) {
  const RecordedMotion recorded = recorded_as(FileFormat::glb, "work.glb");
  Task wrong = box_work().task;
  wrong.actions[0].grasp = "bottle";
  EXPECT_FALSE(score_work(recorded, wrong));
}

}  // namespace
}  // namespace shigusa
