// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/edit.hpp>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "character/character_rig.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "problem/plan_of.hpp"
#include "rollout/reach_problem.hpp"
#include "support/exported.hpp"

namespace shigusa {
namespace {

TaskFile asked(Preset preset) {
  TaskFile file;
  file.character.source = "full_body";  // a spine would have angles that change their sign
  file.preset = preset;
  file.criteria = traits_of(preset).criteria();
  file.goals = {{"right_hand", {-0.25, 0.5, 0.45}}};
  file.evaluations = 200;
  return file;
}

// Angles of dofs with a left and a right change sides; there are no others.
void expect_image(const PosedBody& posed, const Clip& clip, const Clip& image) {
  ASSERT_EQ(clip.frames, image.frames);
  double largest = 0.0;
  for (int f = 0; f < clip.frames; ++f) {
    for (int d = 0; d < clip.dofs; ++d) {
      const int other = posed.body.find_dof(mirrored_name(posed.body.dof(d).name)).value();
      largest = std::fmax(largest, std::fabs(clip.frame(f)[static_cast<std::size_t>(d)] -
                                             image.frame(f)[static_cast<std::size_t>(other)]));
    }
  }
  EXPECT_LT(degrees(largest), 0.5);
}

TEST(Mirror, NamesChangeSides) {
  EXPECT_EQ(mirrored_name("right_hand"), "left_hand");
  EXPECT_EQ(mirrored_name("left_hip.flexion"), "right_hip.flexion");
  EXPECT_EQ(mirrored_name("squat"), "squat");
  EXPECT_EQ(mirrored_name(""), "");
}

class MirroredMotion : public testing::TestWithParam<PresetTraits> {};

TEST_P(MirroredMotion, IsTheImageOfTheMotion) {
  TaskFile file = asked(GetParam().preset);
  const Task task = make_task(file, {}).value();
  const GenerateResult generation = generate(task).value();
  TaskFile other = mirrored(file).value();
  EXPECT_EQ(other.goals[0].effector, "left_hand");
  EXPECT_EQ(other.goals[0].position, (Vec3d{0.25, 0.5, 0.45}));
  const Task image = make_task(other, {}).value();
  const Candidate& best = generation.candidates.front();
  const Parameters across =
      mirrored(parameter_list(task.body, task.start, task).value(),
               parameter_list(image.body, image.start, image).value(), best.parameters);
  const GenerateResult again = regenerate(image, across).value();
  EXPECT_TRUE(again.meets_goals());
  EXPECT_LE(again.candidates[0].goals[0].error, kReachTolerance);
  expect_image(task, best.motion.clip, again.candidates[0].motion.clip);
  EXPECT_NEAR(again.candidates[0].final_posture.trunk_turn, -best.final_posture.trunk_turn, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Preset, MirroredMotion, testing::ValuesIn(kPresets),
                         [](const auto& of) { return std::string(of.param.word); });

// A person with different sides, who stands turned with one foot ahead.
std::string uneven_person() {
  const PosedBody posed = full_body();
  Clip clip{.dofs = posed.body.dof_count(), .frames = 1, .frame_time = 0.1, .angles = {}};
  clip.angles.assign(posed.home.angles.begin(), posed.home.angles.end());
  const auto turn = [&](const char* dof, double angle) {
    clip.angles[static_cast<std::size_t>(posed.body.find_dof(dof).value())] += angle;
  };
  turn("right_shoulder.abduction", 0.3);
  turn("left_elbow.flexion", 0.5);
  SkeletonMotion motion = skeleton_motion(posed, clip);
  for (SkeletonNode& node : motion.skeleton.nodes) {
    if (node.name.starts_with("left_lower_arm")) node.offset = node.offset * 1.1;
  }
  for (std::size_t i = 0; i < motion.skeleton.nodes.size(); ++i) {
    if (motion.skeleton.nodes[i].parent >= 0) {
      motion.clip.local[i].translation = motion.skeleton.nodes[i].offset;
    }
  }
  return format_bvh(motion);
}

TEST(Mirror, TheSamePersonReachesWithTheOtherHandOnTheirOwnSkeleton) {
  TaskFile file = asked(Preset::flat);
  file.character.source = "person.bvh";
  ASSERT_TRUE(load_character(uneven_person(), file.character));
  const Task task = make_task(file, {}).value();
  StoredResult stored = stored_result(file, generate(task).value());
  const Landmarks before = *stored.task.character.landmarks;
  ASSERT_TRUE(mirror_result(stored));
  const Landmarks& person = *stored.task.character.landmarks;
  EXPECT_EQ(person.left_arm.elbow, before.left_arm.elbow);
  ASSERT_TRUE(stored.task.character.rig) << "and so the skeleton is theirs";
  const Task image = make_task(stored.task, {}).value();
  MotionPlayer player = MotionPlayer::of(image).value();
  const GenerateResult mirrored = replay_all(player, stored).value();
  EXPECT_TRUE(mirrored.meets_goals());
  for (const Candidate& candidate : mirrored.candidates) {
    const std::string bvh =
        export_candidate(stored.task.character, image, candidate, FileFormat::bvh).value();
    const testing_support::ExportedMotion motion(bvh, 0.01);
    const int hand = rig_node(stored.task.character, candidate.goals[0].node);
    const std::string& node =
        stored.task.character.rig->skeleton.nodes[static_cast<std::size_t>(hand)].name;
    EXPECT_TRUE(node.starts_with("left_hand"));
    EXPECT_LE(norm(motion.at_end(node) - Vec3d{0.25, 0.5, 0.45}), 1e-3);
    for (const char* foot : {"left_foot", "right_foot"}) {
      EXPECT_LE(motion.slide(foot), 1e-3);
      EXPECT_LE(motion.tilt(foot), radians(0.1));
    }
  }
}

// A motion of random goals and its mirror image, in the form of results.
TEST(Mirror, ScoresAsTheMotionDoes) {
  const Vec3d goals[] = {{0.093, 0.70, 0.207}, {0.038, 0.677, 0.211}, {0.116, 0.283, 0.577},
                         {-0.25, 0.9, 0.4},    {-0.4, 0.2, 0.3},      {-0.3, 1.6, -0.2}};
  int otherwise = 0;
  for (const Vec3d& goal : goals) {
    TaskFile file = asked(Preset::flat);
    file.character.source = "human";
    file.goals = {{"right_hand", goal}};
    const GenerateResult made = generate(make_task(file, {}).value()).value();
    StoredResult stored = stored_result(file, made);
    const std::vector<Parameters> before = stored.candidates;
    ASSERT_TRUE(mirror_result(stored));
    MotionPlayer player = MotionPlayer::of(make_task(stored.task, {}).value()).value();
    const GenerateResult image = replay_all(player, stored).value();
    ASSERT_EQ(image.candidates.size(), made.candidates.size());
    for (std::size_t k = 0; k < made.candidates.size(); ++k) {
      const Candidate& of = made.candidates[k];
      const double off = std::fabs(image.candidates[k].score.total - of.score.total);
      otherwise += off > 0.01 * of.score.total ? 1 : 0;  // which foot the body stands on tells
      EXPECT_LE(off, 0.15 * of.score.total) << goal.x << ' ' << goal.y << ' ' << goal.z;
      EXPECT_EQ(image.candidates[k].judgement.verdict, of.judgement.verdict);
      EXPECT_TRUE(image.candidates[k].parameters.reflected);
    }
    ASSERT_TRUE(mirror_result(stored));
    EXPECT_EQ(stored.candidates, before) << "the image's image is the motion itself";
  }
  EXPECT_LE(otherwise, 1);
}

TEST(Mirror, TwiceIsTheTaskAgain) {
  TaskFile file = asked(Preset::flat);
  file.fixed_assignments = {"right_elbow.weight=3", "twist_deg=20", "twist_rad=-0.1",
                            "squat_deg=40", "nothing"};
  const TaskFile once = mirrored(file).value();
  EXPECT_THAT(once.fixed_assignments,
              testing::ElementsAre("left_elbow.weight=3", "twist_deg=-20", "twist_rad=0.1",
                                   "squat_deg=40", "nothing"));
  EXPECT_EQ(format_task(mirrored(once).value()), format_task(file));
}

TEST(Mirror, HalfABodyHasNone) {
  TaskFile file = asked(Preset::flat);
  file.character.source = "half_body";
  EXPECT_THAT(mirrored(file).error().message, testing::HasSubstr("has one side only"));
}

}  // namespace
}  // namespace shigusa
