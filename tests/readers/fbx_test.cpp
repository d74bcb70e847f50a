// SPDX-License-Identifier: MIT
// A GLB and the FBX that scripts/glb_to_fbx made of it have the same motion, as read by three.js:
// compare_fbx.mjs.
#include <cstdlib>
#include <sstream>

#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

TEST(Fbx, HasTheMotionOfTheGlbThatItIsMadeOf) {
  if (!fs::exists(fs::path(SHIGUSA_READERS_DIR) / "node_modules/three")) {
    GTEST_SKIP() << "no Node.js, or its packages could not be fetched";
  }
  const fs::path man = fs::path(SHIGUSA_SHARED_DIR) / "characters/lab0_CesiumMan.glb";
  if (!fs::exists(man)) GTEST_SKIP() << "no characters here";
  if (std::system("command -v blender > /dev/null") != 0) GTEST_SKIP() << "no Blender here";
  const WorkFolder work;
  const ProgramRun run =
      run_shigusa({"reach", "--character", man.string(), "--goal", "right_hand=-0.2,0.8,0.4",
                   "--evaluations", "200", "--candidates", "1", "--formats", "glb"},
                  {.folder = work.path()});
  ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 3) << run.err;
  const auto quoted = [](const fs::path& path) { return " '" + path.string() + "'"; };
  const std::string files = quoted(work / "out/candidate-1.glb") + quoted(work / "man.fbx");
  ASSERT_EQ(std::system(("'" SHIGUSA_SOURCE_DIR "/scripts/glb_to_fbx'" + files).c_str()), 0);
  const std::string compare = "'" SHIGUSA_NODE "' '" SHIGUSA_READERS_DIR "/compare_fbx.mjs'";
  ASSERT_EQ(std::system((compare + files + " >" + quoted(work / "said")).c_str()), 0);
  std::istringstream said(work.get("said"));
  int joints = 0;
  double off = 1.0;
  double off_skin = 1.0;
  double off_duration = 1.0;
  ASSERT_TRUE(said >> joints >> off >> off_skin >> off_duration);
  EXPECT_EQ(joints, 19);
  // both files have floats, FBX those of angles in degrees
  EXPECT_LT(off, 1e-4);
  EXPECT_LT(off_skin, 1e-4);
  EXPECT_LT(off_duration, 1e-6);
}

// Else a person would look for the fault in the file.
TEST(Fbx, SaysWhatIsMissing) {
  const WorkFolder work;
  const std::string call = "BLENDER=no_blender '" SHIGUSA_SOURCE_DIR
                           "/scripts/glb_to_fbx' a.glb b.fbx 2> '" +
                           (work / "said").string() + "'";
  EXPECT_NE(std::system(call.c_str()), 0);
  EXPECT_NE(work.get("said").find("install Blender"), std::string::npos);
}

}  // namespace
}  // namespace shigusa
