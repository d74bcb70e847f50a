// SPDX-License-Identifier: MIT
// A motion that starts from a frame of an animation has that frame's mesh in its first frame, with
// both skinned by three.js: compare_first_frame.mjs.
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

struct PosedFrame {
  const char* name;
  const char* file;
  const char* animation;
  const char* to_three;  // as three.js calls it
  int frame;             // at 60 Hz
};

class FirstFrame : public testing::TestWithParam<PosedFrame> {
 protected:
  void SetUp() override {
    if (!fs::exists(fs::path(SHIGUSA_READERS_DIR) / "node_modules/three")) {
      GTEST_SKIP() << "no Node.js, or its packages could not be fetched";
    }
    if (std::string(SHIGUSA_SHARED_DIR).empty()) GTEST_SKIP() << "no characters here";
  }

  WorkFolder work_;
};

TEST_P(FirstFrame, HasTheMeshOfTheAnimationsFrame) {
  const PosedFrame& posed = GetParam();
  const fs::path file = fs::path(SHIGUSA_SHARED_DIR) / "characters" / posed.file;
  const ProgramRun run =
      run_shigusa({"reach", "--character", file.string(), "--animation", posed.animation, "--frame",
                   std::to_string(posed.frame), "--goal", "right_hand=-0.2,0.8,0.4",
                   "--evaluations", "8", "--candidates", "1", "--formats", "glb"},
                  {.folder = work_.path()});
  ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 3) << run.err;
  const StoredRun stored(work_, "out");
  const Json& candidate = stored.candidate(1);
  const int node = candidate.at("reached").at(0).at("gltf_node");
  const auto quoted = [](const std::string& text) { return " '" + text + "'"; };
  const std::string call = "'" SHIGUSA_NODE "' '" SHIGUSA_READERS_DIR "/compare_first_frame.mjs'" +
                           quoted(file.string()) + quoted(posed.to_three) +
                           quoted(std::to_string(posed.frame / 60.0)) +
                           quoted((work_ / "out/candidate-1.glb").string()) +
                           quoted(candidate.at("glb_animation").get<std::string>()) +
                           quoted(std::to_string(node)) + " > '" + (work_ / "said").string() + "'";
  ASSERT_EQ(std::system(call.c_str()), 0);
  std::istringstream said(work_.get("said"));
  int vertices = 0;
  double off = 1.0;
  ASSERT_TRUE(said >> vertices >> off);
  EXPECT_GT(vertices, 1000);
  // numbers of both files are floats, and three.js interpolates in them
  EXPECT_LT(off, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Of, FirstFrame,
    testing::Values(PosedFrame{"Step", "lab0_CesiumMan.glb", "0", "animation_0", 30},
                    PosedFrame{"Swing", "lab0_CesiumMan.glb", "0", "animation_0", 61},
                    PosedFrame{"Knight", "KayKit_Knight.glb", "2H_Melee_Idle", "2H_Melee_Idle", 20},
                    PosedFrame{"PickUp", "KayKit_Knight.glb", "PickUp", "PickUp", 40}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace shigusa
