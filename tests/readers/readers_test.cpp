// SPDX-License-Identifier: MIT
// GLB and VRMA as read by three.js, its VRM plugins and Khronos' validator: check_result.mjs.
#include <fmt/format.h>

#include <bit>
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "app/result_checks.hpp"
#include "formats/gltf_animation.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

class SecondReaders : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!fs::exists(fs::path(SHIGUSA_READERS_DIR) / "node_modules/three")) {
      GTEST_SKIP() << "no Node.js, or its packages could not be fetched";
    }
  }

  // Runs check_result.mjs on a result in `out`, and returns its complaints.
  [[nodiscard]] std::string complaints(const fs::path& character) const {
    const std::string call = "SHIGUSA_BINARY='" SHIGUSA_BINARY "' '" SHIGUSA_NODE
                             "' '" SHIGUSA_READERS_DIR "/check_result.mjs' '" +
                             (work_ / "out").string() + "' '" + character.string() + "' > '" +
                             (work_ / "said").string() + "' 2>&1";
    return std::system(call.c_str()) == 0 ? "" : work_.get("said");
  }

  // A reach by a share of the stature, with all that a character leaves in.
  void expect_readable(const fs::path& character, const std::string& hand, const Vec3d& share) {
    const ProgramRun body = run_shigusa({"body", character.string(), "--json"});
    ASSERT_EQ(body.exit_code, 0) << body.err;
    const double stature = Json::parse(body.out).at("stature_m");
    const ProgramRun run = run_shigusa(
        {"reach", "--character", character.string(), "--goal",
         fmt::format("{}_hand={},{},{}", hand, (hand == "left" ? -1 : 1) * share.x * stature,
                     share.y * stature, share.z * stature),
         "--evaluations", "400", "--candidates", "2"},
        {.folder = work_.path()});
    ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 3) << run.err;
    EXPECT_EQ(complaints(character), "") << hand << ' ' << share.y;
  }

  WorkFolder work_;
};

TEST_P(SecondReaders, MeetGoalsWithPlantedFeetOnAnUnchangedMesh) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no characters here";
  for (const char* hand : {"left", "right"}) {
    // low in front, at the feet, high to the side
    for (const Vec3d& share : {Vec3d{-0.1, 0.35, 0.3}, {-0.08, 0.08, 0.15}, {-0.12, 1.0, 0.15}}) {
      expect_readable(fs::path(shared) / "characters" / GetParam(), hand, share);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SecondReaders,
                         testing::Values("VRM-Addon-for-Blender__basic_armature.vrm",
                                         "VRM-Addon-for-Blender__debug_robot.vrm",
                                         "VRM-Addon-for-Blender__armature_transform.vrm",
                                         "KayKit_Knight.glb", "lab0_CesiumMan.glb"),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });

// All people's files, in all formats in which their motions are written.
class EveryCharacter : public SecondReaders {};

TEST_P(EveryCharacter, LeavesAsItIsComputed) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no characters here";
  const fs::path character = fs::path(shared) / "characters" / GetParam();
  const std::string ending = character.extension();
  const ProgramRun run =
      run_shigusa({"reach", "--character", character.string(), "--goal", "right_hand=-0.2,0.9,0.3",
                   "--evaluations", "300", "--candidates", "1", "--formats",
                   ending == ".vrm"   ? "bvh,glb,vrma"
                   : ending == ".glb" ? "bvh,glb"
                                      : "bvh"},
                  {.folder = work_.path()});
  ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 3) << run.err;
  EXPECT_EQ(run.err.find("files: note"), std::string::npos) << run.err;
  EXPECT_EQ(complaints(character), "");
}

INSTANTIATE_TEST_SUITE_P(
    Of, EveryCharacter,
    testing::Values("Geno.fbx", "KayKit_Knight.glb", "Quaternius_Character_HumanoidRig.glb",
                    "Quaternius_cyberpunk_Character.glb", "Quaternius_platformer_Character.glb",
                    "RobotExpressive.glb", "VRM-Addon-for-Blender__armature_transform.vrm",
                    "VRM-Addon-for-Blender__basic_armature.vrm",
                    "VRM-Addon-for-Blender__debug_robot.vrm", "assimp__Boxing_Toes.bvh",
                    "blender-cli-rendering__102_01.bvh", "bvhtoolbox_walk01.bvh",
                    "cats_mannyquin.glb", "cats_minnyquinn.glb", "fairmotion__pfnn_hierarchy.bvh",
                    "godot_platformer_player.glb", "lab0_CesiumMan.glb", "makehuman_tpose.bvh",
                    "makehuman_zombie.bvh", "mannequiny.glb", "mjolnir_BrainStem.glb",
                    "pybvh__bvh_test1.bvh", "pybvh__standard_skeleton.bvh",
                    "ufbx_humanik_7400_ascii.fbx"),
    [](const auto& of) {
      std::string name = of.param;
      std::erase_if(name, [](char c) { return !std::isalnum(c); });
      return name;
    });

// Animations of files from other authors, each node in each frame.
class AnimationsBesideThree : public SecondReaders {};

TEST_P(AnimationsBesideThree, AreSampledAlike) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  // splines, steps and shorts, which the characters have none of
  const bool own = GetParam() == std::string("animated.glb");
  if (!own && shared.empty()) GTEST_SKIP() << "no characters here";
  const fs::path file = own ? fs::path(SHIGUSA_SOURCE_DIR) / "tests/fuzz/gltf_corpus" / GetParam()
                            : fs::path(shared) / "characters" / GetParam();
  constexpr double kRate = 25.0;  // no file's own
  const GltfMotion motion = read_gltf_animation(file, {.frame_rate = kRate}).value();
  // three.js names nameless nodes itself
  const bool named = motion.animation != "0";
  std::string nodes;
  for (const int node : motion.character.file_node) {
    nodes += (nodes.empty() ? "" : ",") + std::to_string(node);
  }
  const std::string call = "'" SHIGUSA_NODE "' '" SHIGUSA_READERS_DIR "/sample_animation.mjs' '" +
                           file.string() + "' '" + (named ? "" : "animation_") + motion.animation +
                           "' " + std::to_string(kRate) + " " + nodes + " > '" +
                           (work_ / "said").string() + "'";
  ASSERT_EQ(std::system(call.c_str()), 0);
  std::istringstream said(work_.get("said"));
  double most = 0.0;
  for (int f = 0; f < motion.motion.clip.frames; ++f) {
    for (const auto& ours : world_transforms(motion.motion.skeleton, motion.motion.clip, f)) {
      Vec3d theirs;
      ASSERT_TRUE(said >> theirs.x >> theirs.y >> theirs.z) << "frame " << f;
      most = max(most, norm(ours.translation - theirs));
    }
  }
  std::string more;
  EXPECT_FALSE(said >> more);
  // three.js interpolates in single precision
  EXPECT_LT(most, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Of, AnimationsBesideThree,
                         testing::Values("animated.glb", "KayKit_Knight.glb", "lab0_CesiumMan.glb",
                                         "mjolnir_BrainStem.glb"),
                         [](const auto& of) {
                           const std::string name = of.param;
                           return name.substr(0, name.find_first_of("_."));
                         });

using SecondReadersOfOurOwn = SecondReaders;

TEST_F(SecondReadersOfOurOwn, ReadTheMannequinsOfBuiltInBodies) {
  if (!has_mannequin()) GTEST_SKIP() << "no mannequin in this build";
  for (const char* goal : {"right_hand=-0.2,1.1,0.4", "left_hand=0.1,0.3,0.4"}) {
    const ProgramRun run = run_shigusa({"reach", "--goal", goal, "--evaluations", "400",
                                        "--candidates", "2", "--formats", "bvh,glb"},
                                       {.folder = work_.path()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(complaints("human"), "") << goal;
  }
}

// A triangle on the hand, which needs no person's file.
TEST_F(SecondReadersOfOurOwn, ReadAPersonWithAMesh) {
  nlohmann::json file = person_gltf();
  std::string binary;
  for (const float value : {0.f, 0.f, 0.f, 0.1f, 0.f, 0.f, 0.f, 0.1f, 0.f}) {
    binary += word_bytes(std::bit_cast<std::uint32_t>(value));
  }
  file["scene"] = 0;
  file["scenes"] = {{{"nodes", {0}}}};
  file["buffers"] = {{{"byteLength", binary.size()}}};
  file["bufferViews"] = {{{"buffer", 0}, {"byteLength", binary.size()}, {"target", 34962}}};
  file["accessors"] = {{{"bufferView", 0},
                        {"componentType", 5126},
                        {"count", 3},
                        {"type", "VEC3"},
                        {"min", {0, 0, 0}},
                        {"max", {0.1f, 0.1f, 0}}}};
  file["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
  for (nlohmann::json& node : file["nodes"]) {
    if (node.value("name", "") == "right_hand") node["mesh"] = 0;
  }
  const fs::path person = work_.put("person.glb", glb(file.dump(), binary));
  expect_readable(person, "right", {-0.1, 0.4, 0.3});
  expect_readable(person, "left", {-0.1, 0.4, 0.3});
  // they would complain: of a goal elsewhere, a node that moves as a foot, another mesh
  const std::string summary = work_.get("out/summary.json");
  Json changed = Json::parse(summary);
  changed["candidates"][0]["reached"][0]["goal_m"][1] = 0.8;
  work_.put("out/summary.json", changed.dump());
  EXPECT_THAT(complaints(person), testing::HasSubstr("the goal is missed"));
  changed = Json::parse(summary);
  changed["candidates"][0]["contacts"][0]["gltf_node"] =
      changed["candidates"][0]["reached"][0]["gltf_node"];
  work_.put("out/summary.json", changed.dump());
  EXPECT_THAT(complaints(person), testing::HasSubstr("a foot slides"));
  // and of nothing to look at
  changed = Json::parse(summary);
  for (const char* list : {"reached", "contacts"}) changed["candidates"][0][list] = Json::array();
  work_.put("out/summary.json", changed.dump());
  EXPECT_THAT(complaints(person), testing::AllOf(testing::HasSubstr("no goal to look at"),
                                                 testing::HasSubstr("no foot to look at")));
  changed["candidates"] = Json::array();
  work_.put("out/summary.json", changed.dump());
  EXPECT_THAT(complaints(person), testing::HasSubstr("there is no candidate"));
  work_.put("out/summary.json", summary);
  file["accessors"][0]["max"] = {0.2f, 0.1f, 0};
  const fs::path other = work_.put(
      "other.glb",
      glb(file.dump(), binary.replace(12, 4, word_bytes(std::bit_cast<std::uint32_t>(0.2f)))));
  EXPECT_THAT(complaints(other), testing::HasSubstr("a vertex is off"));
}

}  // namespace
}  // namespace shigusa
