// SPDX-License-Identifier: MIT
// People's own characters move a cup and stand up again, whatever their file calls its joints.
#include <gtest/gtest.h>

#include <filesystem>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <string>

namespace shigusa {
namespace {

class OwnCharacter : public testing::TestWithParam<const char*> {};

TEST_P(OwnCharacter, MovesACupAndStandsUpAgain) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no recorded characters here";
  TaskFile file;
  file.character.source = shared + "/characters/" + GetParam();
  if (!std::filesystem::exists(file.character.source)) GTEST_SKIP() << "no " << GetParam();
  file.things = {{.name = "cup",
                  .shape = ThingShape::cylinder,
                  .size = {0.08, 0.1, 0.08},
                  .mass = 0.4,
                  .position = {-0.25, 0.95, 0.4},
                  .upright = true}};
  file.actions = {{.grasp = "cup", .with = {"right_hand"}},
                  {.place = "cup", .position = Vec3d{0.1, 0.95, 0.42}},
                  {.stand = Stance{}}};
  const Task task = make_task(file, {}).value();
  const GenerateResult result = perform(task).value();
  EXPECT_TRUE(result.meets_goals()) << result.conflict.text;
  const Candidate& best = result.candidates.front();
  EXPECT_NE(best.judgement.verdict, Verdict::impossible);
  ASSERT_EQ(best.actions.size(), 3U);
  ASSERT_TRUE(best.actions[1].placed);
  EXPECT_LT(best.actions[1].placed->error, 1e-3);
  EXPECT_LT(best.final_posture.knee_flexion, radians(30.0));
}

INSTANTIATE_TEST_SUITE_P(Files, OwnCharacter,
                         testing::Values("lab0_CesiumMan.glb",
                                         "VRM-Addon-for-Blender__basic_armature.vrm",
                                         "mannequiny.glb", "cats_mannyquin.glb",
                                         "makehuman_tpose.bvh"));

}  // namespace
}  // namespace shigusa
