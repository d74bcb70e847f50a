// SPDX-License-Identifier: MIT
// Strips of pieces of work: their poses, the names of actions, and things that move.
#include "draw/work_strip.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "draw/candidate_strip.hpp"
#include "draw/strip_figure_painter.hpp"
#include "strip_support.hpp"
#include "support/work.hpp"

namespace shigusa {
namespace {

using namespace strip_support;
using namespace testing_support;
using testing::HasSubstr;

// A candidate whose actions end at these frames of a clip of 60 Hz.
Candidate ending_at(const std::vector<int>& ends, int frames) {
  Candidate candidate;
  candidate.motion.clip.frames = frames;
  candidate.motion.clip.frame_time = 1.0 / 60.0;
  double start = 0.0;
  for (const int end : ends) {
    candidate.actions.push_back({.kind = ActionKind::grasp, .start = start, .end = end / 60.0});
    start = end / 60.0;
  }
  return candidate;
}

TEST(WorkStrip, PosesAreTheEndsOfActionsAndFramesBetweenThem) {
  const std::vector<int> frames = work_frames(ending_at({100, 160, 200}, 201));
  EXPECT_THAT(frames, testing::ElementsAre(0, 50, 100, 130, 160, 180, 200));
  EXPECT_THAT(work_frames(ending_at({120}, 121)), testing::ElementsAre(0, 15, 30, 45, 60, 90, 120));
  EXPECT_TRUE(work_frames(ending_at({}, 121)).empty());
}

TEST(WorkStrip, PosesOfManyActionsAreTheirEnds) {
  std::vector<int> ends;
  for (int k = 1; k <= 64; ++k) ends.push_back(10 * k);
  const std::vector<int> frames = work_frames(ending_at(ends, 641));
  EXPECT_EQ(frames.size(), static_cast<std::size_t>(kStripMaxPoses));
  EXPECT_TRUE(std::is_sorted(frames.begin(), frames.end()));
  ends.resize(20);
  EXPECT_EQ(work_frames(ending_at(ends, 201)).size(), 21u);
  EXPECT_EQ(work_frames(ending_at({0}, 1)), std::vector<int>{0});
}

TEST(WorkStrip, NamesStandWhereActionsBeginAndNoneCoversAnother) {
  strip::Strip strip;
  for (int k = 0; k < 5; ++k) {
    strip.slots.emplace_back();
    strip.slots.back().frame = 10 * k;
    strip.slots.back().x = 50.0 + 20.0 * k;
  }
  const std::vector<StripAction> actions{
      {"grasp", 0, 10}, {"release", 10, 10}, {"place", 10, 40}, {"stand", 40, 40}};
  const auto labels = strip::action_labels(strip, actions, 400.0);
  ASSERT_EQ(labels.size(), 4u);
  EXPECT_EQ(labels[0].x, 50.0);
  EXPECT_EQ(labels[1].x, 70.0);
  EXPECT_EQ(labels[2].x, 70.0);
  EXPECT_EQ(labels[3].x, 130.0);
  for (std::size_t a = 0; a < labels.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (labels[a].row != labels[b].row) continue;
      const double half = 0.5 * (strip::text_width(labels[a].name, strip::kText) +
                                 strip::text_width(labels[b].name, strip::kText));
      EXPECT_GT(std::abs(labels[a].x - labels[b].x), half);
    }
  }
}

TEST(WorkStrip, ThingsAreDrawnWhereTheyAreAtThatTime) {
  SkeletonMotion motion = standing(3);
  StripOverlay overlay;
  StripThing ball{{Vec3d{}}, 0.1, {}};
  for (const double y : {0.1, 0.5, 1.2}) ball.poses.push_back({{}, {0.3, y, 0.3}});
  overlay.things = {ball};
  StripSettings settings;
  settings.frames = {0, 2};
  const strip::Strip laid = strip::lay_out(motion, overlay, settings).value();
  ASSERT_EQ(laid.slots.size(), 2u);
  ASSERT_EQ(laid.slots[0].things.size(), 1u);
  const auto top = [&](std::size_t slot) {
    const auto& face = laid.slots[slot].things.at(0).face;
    return std::max_element(face.begin(), face.end(),
                            [](const auto& a, const auto& b) { return a.y < b.y; })
        ->y;
  };
  EXPECT_NEAR(top(1) - top(0), 1.1 * cos(radians(settings.elevation_deg)), 1e-9);
  // in front of the figure on its left, seen from its right
  EXPECT_TRUE(laid.slots[0].things[0].moves);
}

TEST(WorkStrip, OfAPieceOfWorkTellsItsActionsAndIsDrawnTheSameAgain) {
  const Work& work = box_work();
  const MotionStrip strip = candidate_strip(work.task, work.generation.candidates.front());
  ASSERT_EQ(strip.overlay.things.size(), 2u);
  EXPECT_EQ(strip.overlay.things[0].corners.size(), 8u);
  EXPECT_EQ(strip.overlay.things[1].corners.size(), 32u);
  EXPECT_TRUE(strip.overlay.goals.empty());
  const std::string svg = draw_strip(strip.motion, strip.overlay, strip.settings).value();
  EXPECT_THAT(svg, HasSubstr(">grasp</text>"));
  EXPECT_THAT(svg, HasSubstr(">place</text>"));
  EXPECT_EQ(svg, draw_strip(strip.motion, strip.overlay, strip.settings).value());
  // both arms act
  const auto& accented = strip.settings.accented;
  for (const Limb limb : {Limb::left_arm, Limb::right_arm}) {
    EXPECT_NE(std::find(accented.begin(), accented.end(), limb), accented.end());
  }
}

TEST(WorkStrip, FramesAndPosesThatDoNotFitAreRefused) {
  const auto refusal = [](const StripOverlay& overlay, const std::vector<int>& frames) {
    StripSettings settings;
    settings.frames = frames;
    const auto drawn = draw_strip(standing(3), overlay, settings);
    return drawn ? std::string("drawn") : drawn.error().to_string();
  };
  EXPECT_EQ(refusal({}, {0, 2}), "drawn");
  EXPECT_EQ(refusal({}, {0, 3}), "frames: 3 after 0; the clip has 0 to 2, and they ascend");
  EXPECT_EQ(refusal({}, {1, 1}), "frames: 1 after 1; the clip has 0 to 2, and they ascend");
  StripOverlay overlay;
  overlay.things = {{{Vec3d{}}, 0.1, {Transformd{}}}};
  EXPECT_EQ(refusal(overlay, {}), "thing 0: 1 poses given; 0 or 3 allowed");
  overlay.things = {};
  overlay.actions = {{"\xff", 0, 1}};
  EXPECT_EQ(refusal(overlay, {}), "name of an action: byte 0 is not UTF-8 text");
  overlay.actions = {{"grasp", 2, 1}};
  EXPECT_EQ(refusal(overlay, {}), "begin of an action: 2 given; 0 to 1 allowed");
}

}  // namespace
}  // namespace shigusa
