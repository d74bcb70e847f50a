// SPDX-License-Identifier: MIT
// A person of an FBX file, written as BVH and as the GLB of the skeleton.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "character/character_rig.hpp"
#include "formats/gltf.hpp"
#include "support/exported.hpp"
#include "support/exported_glb.hpp"
#include "support/fbx_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

class FbxCharacter : public testing::Test {
 protected:
  WorkFolder folder_;
  TaskFile file_;

  // As tools write it: centimetres, z up, turned joints, a mesh beside the skeleton.
  Task task_of(bool binary) {
    FbxFile fbx(standing_figure().transformed({{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}));
    fbx.axes = {2, 1, 1, -1, 0, 1};
    fbx.pre_rotation = {0, 20, 90};
    fbx.meshes = true;
    file_.character.source = folder_.put("person.fbx", binary ? fbx.bytes() : fbx.text());
    file_.goals = {{"right_hand", {-0.2, 0.6, 0.35}}};
    file_.evaluations = 200;
    return make_task(file_, {}).value();
  }
};

TEST_F(FbxCharacter, IsThePersonOfItsJoints) {
  for (const bool binary : {false, true}) {
    file_ = {};
    task_of(binary);
    EXPECT_NEAR(*file_.character.stature, 1.7, 1e-6);
    EXPECT_THAT(file_.character.doubts, testing::ElementsAre(testing::HasSubstr("they hang")));
    EXPECT_THAT(file_.character.humanoid,
                testing::Contains(std::pair<std::string, std::string>("left_hand", "LeftHand")));
  }
}

TEST_F(FbxCharacter, LeavesOnItsOwnNodesAsBvhAndGlb) {
  const Task task = task_of(true);
  const GenerateResult generation = generate(task).value();
  ASSERT_TRUE(generation.meets_goals());
  const Candidate& candidate = generation.candidates[0];
  const auto exported = [&](FileFormat format) {
    return export_candidate(file_.character, task, candidate, format, {.animation = "reach"})
        .value();
  };
  const ExportedMotion bvh(exported(FileFormat::bvh), 0.01);
  EXPECT_LT(norm(bvh.at_end("RightHand") - task.goals[0].position), 1e-3);
  EXPECT_LT(bvh.slide("LeftFoot"), 1e-3);
  const std::string glb = exported(FileFormat::glb);
  const GltfCharacter skeleton = parse_gltf(glb, "out.glb").value();
  EXPECT_GE(skeleton.rest.skeleton.find("LeftToeBase"), 0);
  const ExportedGlb moving(glb);
  const int hand =
      file_.character.rig
          ->file_node[static_cast<std::size_t>(rig_node(file_.character, "right_hand_grip"))];
  EXPECT_LT(norm(moving.at(hand, "reach", moving.frames("reach") - 1) - task.goals[0].position),
            1e-3);
}

TEST_F(FbxCharacter, ResultKeepsThePersonAndTakesTheFileAgain) {
  const Task task = task_of(false);
  StoredResult stored =
      parse_result(format_result({file_, task, generate(task).value()}), "summary.json").value();
  EXPECT_TRUE(make_task(stored.task, "/nowhere"));
  EXPECT_TRUE(attach_file(stored.task.character, folder_.path() / "person.fbx"));
}

TEST_F(FbxCharacter, OlderFilesAreToldHowToBecomeNewer) {
  CharacterSpec spec{.source = "old.fbx"};
  const std::string old = "FBXHeaderExtension:  {\n\tFBXVersion: 5800\n}\n";
  EXPECT_THAT(load_character(old, spec).error().to_string(), HasSubstr("FBX 7.4 (2014)"));
}

}  // namespace
}  // namespace shigusa
