// SPDX-License-Identifier: MIT
// An exported BVH as read by assimp, which other tools use.
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <nlohmann/json.hpp>
#include <shigusa/files.hpp>

#include "support/exported.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Positions of the file's nodes by assimp's reading of hierarchy and motion.
class AssimpMotion {
 public:
  explicit AssimpMotion(const std::string& bvh) {
    const aiScene* scene = importer_.ReadFileFromMemory(bvh.data(), bvh.size(), 0, "bvh");
    SHG_CHECK(scene != nullptr && scene->mNumAnimations == 1, importer_.GetErrorString());
    root_ = scene->mRootNode;
    animation_ = scene->mAnimations[0];
  }

  [[nodiscard]] int frames() const {
    return static_cast<int>(animation_->mChannels[0]->mNumRotationKeys);
  }

  // (file units)
  [[nodiscard]] Vec3d at(const std::string& name, int frame) const {
    aiMatrix4x4 world;
    for (const aiNode* node = root_->FindNode(name.c_str()); node != nullptr;
         node = node->mParent) {
      world = local(*node, frame) * world;
    }
    return {world.a4, world.b4, world.c4};
  }

 private:
  // assimp leaves one key where all are alike
  template <class Key>
  static const Key& key_of(const Key* keys, unsigned count, int frame) {
    return keys[count == 1 ? 0 : frame];
  }

  [[nodiscard]] aiMatrix4x4 local(const aiNode& node, int frame) const {
    for (unsigned i = 0; i < animation_->mNumChannels; ++i) {
      const aiNodeAnim& channel = *animation_->mChannels[i];
      if (channel.mNodeName != node.mName) continue;
      const auto& turned = key_of(channel.mRotationKeys, channel.mNumRotationKeys, frame);
      const auto& moved = key_of(channel.mPositionKeys, channel.mNumPositionKeys, frame);
      return {aiVector3D(1, 1, 1), turned.mValue, moved.mValue};
    }
    return node.mTransformation;
  }

  Assimp::Importer importer_;
  const aiNode* root_ = nullptr;
  const aiAnimation* animation_ = nullptr;
};

class AssimpReadsExport : public testing::TestWithParam<const char*> {
 protected:
  AssimpReadsExport() : task_(make()), candidate_(generated()), bvh_(exported()), motion_(bvh_) {}

  static Task make() {
    TaskFile file;
    file.character.source = GetParam();
    file.goals = {{"right_hand", kGoal}};
    return make_task(file, {}).value();
  }
  [[nodiscard]] Candidate generated() const {
    return regenerate(task_, uniform_parameters(task_.body)).value().candidates[0];
  }
  [[nodiscard]] std::string exported() const {
    return export_candidate(task_, candidate_, FileFormat::bvh).value();
  }

  static constexpr Vec3d kGoal{0.25, 0.55, 0.5};
  static constexpr double kCentimetre = 0.01;  // m, the file's unit
  static constexpr double kMillimetre = 1e-3;

  Task task_;
  Candidate candidate_;
  std::string bvh_;
  AssimpMotion motion_;
};

TEST_P(AssimpReadsExport, HandEndsOnItsGoal) {
  const Vec3d end = motion_.at(candidate_.goals[0].node, motion_.frames() - 1) * kCentimetre;
  EXPECT_LE(norm(end - kGoal), kMillimetre);
}

TEST_P(AssimpReadsExport, FeetStayWhereTheyStand) {
  for (const ContactResult& foot : candidate_.contacts) {
    for (int f = 0; f < motion_.frames(); ++f) {
      const Vec3d moved = motion_.at(foot.node, f) - motion_.at(foot.node, 0);
      EXPECT_LE(norm(moved) * kCentimetre, kMillimetre) << foot.node << ' ' << f;
    }
  }
}

TEST_P(AssimpReadsExport, EveryJointIsWhereOurReaderPutsIt) {
  const ExportedMotion ours(bvh_, 1.0);
  ASSERT_EQ(motion_.frames(), ours.frames());
  for (const SkeletonNode& node : ours.motion().skeleton.nodes) {
    if (node.end_site) continue;
    for (int f = 0; f < ours.frames(); f += 10) {
      // assimp computes in single precision: some 1e-7 of 200 cm per joint of a chain of ten
      EXPECT_LE(norm(motion_.at(node.name, f) - ours.at(node.name, f)), 1e-3) << node.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, AssimpReadsExport, testing::Values("half_body", "full_body"),
                         [](const auto& of) { return std::string(of.param); });

// BVH characters, whose motions are written on the file's own nodes.
class AssimpReadsCharacter : public testing::TestWithParam<const char*> {};

TEST_P(AssimpReadsCharacter, HandEndsWhereItIsToldAndFeetStay) {
  const std::string shared = SHIGUSA_SHARED_DIR;
  if (shared.empty()) GTEST_SKIP() << "no recorded characters here";
  const WorkFolder work;
  for (const char* hand : {"left_hand", "right_hand"}) {
    // low in front, at the feet, high to the side
    for (Vec3d share : {Vec3d{-0.1, 0.35, 0.3}, {-0.08, 0.08, 0.15}, {-0.12, 1.0, 0.15}}) {
      TaskFile file;
      file.character.source = shared + "/characters/" + GetParam();
      ASSERT_TRUE(measure_character(file.character, {}));
      if (hand[0] == 'l') share.x = -share.x;
      file.goals = {{hand, share * *file.character.stature}};
      file.evaluations = 400;
      file.candidates = 2;
      const Task task = make_task(file, {}).value();
      const GenerateResult generation = generate(task).value();
      const auto summary = nlohmann::json::parse(
          write_result(work.path(), {file, task, generation}, {{FileFormat::bvh}}).value().summary);
      for (const auto& candidate : summary.at("candidates")) {
        const AssimpMotion motion(work.get(candidate.at("files").at("bvh")));
        const double unit = candidate.at("bvh_unit_m");
        ASSERT_EQ(motion.frames(), candidate.at("file_frames"));
        const auto& goal = candidate.at("reached").at(0);
        const std::vector<double> told = goal.at("reached_m");
        const Vec3d end = motion.at(goal.at("joint"), motion.frames() - 1) * unit;
        // assimp computes in single precision, metres from the origin
        EXPECT_LE(norm(end - Vec3d{told[0], told[1], told[2]}), 2e-5) << hand << share.y;
        if (generation.meets_goals()) {
          EXPECT_LE(goal.at("error_mm").get<double>(), 1.0);
        }
        for (const auto& foot : candidate.at("contacts")) {
          for (int f = 0; f < motion.frames(); ++f) {
            const Vec3d moved = motion.at(foot.at("joint"), f) - motion.at(foot.at("joint"), 0);
            EXPECT_LE(norm(moved) * unit, 1e-3) << foot.at("joint") << ' ' << f;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, AssimpReadsCharacter,
                         testing::Values("assimp__Boxing_Toes.bvh", "pybvh__bvh_test1.bvh",
                                         "pybvh__standard_skeleton.bvh",
                                         "fairmotion__pfnn_hierarchy.bvh",
                                         "blender-cli-rendering__102_01.bvh"),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::erase_if(name,
                                         [](char c) { return c == '_' || c == '.' || c == '-'; });
                           return name;
                         });

}  // namespace
}  // namespace shigusa
