// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/run.hpp>
#include <shigusa/score.hpp>

#include "kinematics/skeleton_motion.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

GenerateResult small_generation(const Task& task) {
  Task quick = task;
  quick.evaluations = 300;
  quick.candidates = 1;
  return generate(quick).value();
}

Task low_reach(PosedBody posed) {
  Task task(std::move(posed));
  task.goals = {{"right_hand", {-0.1, 0.5, 0.4}}};
  task.duration = 1.4;  // in haste jolts depend on the file's rate
  return task;
}

class ClipScoreTest : public testing::Test {
 protected:
  std::string write(const SkeletonMotion& motion) {
    work_.put("clip.bvh", format_bvh(motion));
    return (work_.path() / "clip.bvh").string();
  }

  WorkFolder work_;
};

// Generated, written, read and fitted: the figures of the summary. A generated motion is at rest
// before its first frame and after its last, a file's continues at its velocity: two frames of 61
// differ.
TEST_F(ClipScoreTest, AMotionOfItsOwnScoresAsItsSummaryHasIt) {
  for (const char* name : {"full_body", "human"}) {
    const Task task = low_reach(name == std::string("human") ? human_body() : full_body());
    const GenerateResult generation = small_generation(task);
    const Candidate& candidate = generation.candidates.front();
    const std::string path = write(skeleton_motion(task.body, candidate.motion.clip));
    const RecordedMotion recorded = read_recorded(path, {.source = name}, 0).value();
    const ClipScore score = score_clip(recorded, {.cutoff = 0.0}).value();
    EXPECT_LT(score.fit.worst_distance, 1e-5) << name;
    EXPECT_TRUE(score.doubts.empty()) << name;
    ASSERT_EQ(score.score.terms.size(), candidate.score.terms.size());
    for (std::size_t i = 0; i < score.score.terms.size(); ++i) {
      EXPECT_EQ(score.score.terms[i].name, candidate.score.terms[i].name);
      // a file does not state which hands reach, and its first frame does not begin at rest
      const std::string& term = score.score.terms[i].name;
      const bool of_hands = term == "hand_curve" || term == "trunk_travel" ||
                            term == "mass_ahead" || term == "coordination";
      const double slack = term == "jolts" ? 0.2 : of_hands ? 0.1 : 1e-4;
      EXPECT_NEAR(score.score.terms[i].penalty, candidate.score.terms[i].penalty,
                  0.03 * candidate.score.terms[i].penalty + slack)
          << name << " " << score.score.terms[i].name;
    }
    // a motion of a second is slower than the cutoff, but for jolts of a search this small
    const ClipScore smoothed = score_clip(recorded).value();
    EXPECT_NEAR(smoothed.score.total, candidate.score.total, 0.4 * candidate.score.total) << name;
  }
}

// Another person's body, built from the file itself: the same angles, the same joints.
TEST_F(ClipScoreTest, TheClipsOwnPersonFollowsItExactly) {
  const Task task = low_reach(human_body({.stature = 1.6, .mass = default_mass(1.6, Sex::male)}));
  const Candidate candidate = small_generation(task).candidates.front();
  const std::string path = write(skeleton_motion(task.body, candidate.motion.clip));
  const CharacterSpec person{.source = path, .extent = BodyExtent::human};
  const RecordedMotion recorded = read_recorded(path, person, 0).value();
  const ClipScore score = score_clip(recorded, {.cutoff = 0.0}).value();
  EXPECT_NEAR(recorded.body.stature(), 1.6, 1e-3);
  EXPECT_LT(score.fit.worst_distance, 1e-5);
  for (std::size_t i = 0; i < score.score.terms.size(); ++i) {
    // the file's own rate makes other jolts
    const std::string& term = score.score.terms[i].name;
    EXPECT_NEAR(score.score.terms[i].penalty, candidate.score.terms[i].penalty,
                term == "jolts" ? 0.3 : 2e-3)
        << term;
  }
}

// Noise of a twentieth of a degree, usual in motion capture, is some 4 rad/s² at 60 Hz.
TEST_F(ClipScoreTest, SmoothingTakesNoiseOutOfAccelerations) {
  const Task task = low_reach(full_body());
  const Candidate candidate = small_generation(task).candidates.front();
  Clip noisy = candidate.motion.clip;
  Random random(7);
  for (double& angle : noisy.angles) angle += radians(0.05) * (2.0 * random.uniform() - 1.0);
  const std::string path = write(skeleton_motion(task.body, noisy));
  const RecordedMotion recorded = read_recorded(path, {.source = "full_body"}, 0).value();
  ScoreSettings settings;
  settings.criteria[CriterionKind::joint_acceleration].scale = 20.0;
  const double clean = score_motion(task.body, candidate.motion, settings.criteria).total;
  const double smoothed = score_clip(recorded, settings).value().score.total;
  settings.cutoff = 0.0;
  const double raw = score_clip(recorded, settings).value().score.total;
  EXPECT_LT(std::abs(smoothed - clean), 0.3 * std::abs(raw - clean));
}

// Each posture is searched from the start posture, and may have similar solutions beside it.
TEST_F(ClipScoreTest, PosturesFarFromTheStartAreFound) {
  for (const PosedBody& posed : {full_body(), human_body()}) {
    Clip clip{.dofs = posed.body.dof_count(), .frames = 8, .angles = {}};
    clip.angles.assign(posed.home.angles.begin(), posed.home.angles.end());
    Random random(1);
    for (int f = 1; f < clip.frames; ++f) {
      for (const Dof& dof : posed.body.dofs())
        clip.angles.push_back(random.uniform(dof.lower, dof.upper));
    }
    const std::string path = write(skeleton_motion(posed, clip));
    const RecordedMotion recorded = read_recorded(path, {.source = posed.body.name()}, 0).value();
    for (int f = 1; f < clip.frames; ++f) {
      const ClipScore score = score_clip(recorded, {.first = f, .last = f, .cutoff = 0.0}).value();
      EXPECT_LT(score.fit.worst_distance, 0.05) << posed.body.name() << " frame " << f;
    }
  }
}

TEST_F(ClipScoreTest, AFootThatStepsIsADoubtAndNoRefusal) {
  const PosedBody posed = full_body();
  Clip clip{.dofs = posed.body.dof_count(), .frames = 20, .angles = {}};
  const auto hip = static_cast<std::size_t>(posed.body.find_dof("left_hip.flexion").value());
  for (int f = 0; f < clip.frames; ++f) {
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    if (f >= 10) angles[hip] += 0.02 * (f - 10);
    clip.angles.insert(clip.angles.end(), angles.begin(), angles.end());
  }
  const std::string path = write(skeleton_motion(posed, clip));
  const RecordedMotion recorded = read_recorded(path, {.source = "full_body"}, 0).value();
  const ClipScore all = score_clip(recorded).value();
  ASSERT_EQ(all.doubts.size(), 1U);
  EXPECT_THAT(all.doubts.front(), HasSubstr("left_foot moves by"));
  EXPECT_LT(all.fit.worst_distance, 1e-5);  // the leg is free to follow
  EXPECT_TRUE(score_clip(recorded, {.last = 10}).value().doubts.empty());
}

// A motion beyond a limit is reported, and replayed unchanged.
TEST_F(ClipScoreTest, LimitsThatTheRecordPassesAreReported) {
  const PosedBody posed = full_body();
  const auto elbow = static_cast<std::size_t>(posed.body.find_dof("right_elbow.flexion").value());
  const double beyond = posed.body.dof(static_cast<int>(elbow)).upper + radians(8.0);
  Clip clip{.dofs = posed.body.dof_count(), .frames = 120, .angles = {}};
  for (int f = 0; f < clip.frames; ++f) {
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    angles[elbow] += (beyond - angles[elbow]) * f / 119.0;
    clip.angles.insert(clip.angles.end(), angles.begin(), angles.end());
  }
  const std::string path = write(skeleton_motion(posed, clip));
  const RecordedMotion recorded = read_recorded(path, {.source = "full_body"}, 0).value();
  const ClipScore score = score_clip(recorded).value();
  ASSERT_EQ(score.measures.over_limit.size(), 1U);
  EXPECT_EQ(score.measures.over_limit.front().dof, "right_elbow.flexion");
  EXPECT_NEAR(score.measures.over_limit.front().excess, radians(8.0), radians(0.1));
}

TEST_F(ClipScoreTest, WhatCannotBeScoredIsRefusedWithAReason) {
  const PosedBody posed = full_body();
  Clip clip{.dofs = posed.body.dof_count(), .frames = 1, .angles = {}};
  clip.angles.assign(posed.home.angles.begin(), posed.home.angles.end());
  const std::string path = write(skeleton_motion(posed, clip));
  const RecordedMotion recorded = read_recorded(path, {.source = path}, 0).value();
  EXPECT_THAT(score_clip(recorded, {.first = 1}).error().to_string(),
              HasSubstr("the file has 0 to 0"));
  EXPECT_THAT(score_clip(recorded, {.cutoff = -1.0}).error().to_string(), HasSubstr("-1 Hz"));
  EXPECT_TRUE(score_clip(recorded).has_value());
  EXPECT_THAT(read_recorded(path, {.source = "robot.urdf"}, 0).error().to_string(),
              HasSubstr("is a robot"));
  EXPECT_THAT(read_recorded("clip.csv", {.source = path}, 0).error().to_string(),
              HasSubstr("allowed are .bvh"));
}

}  // namespace
}  // namespace shigusa
