// SPDX-License-Identifier: MIT
// An exported BVH as assimp, which other tools read it by, understands it.
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <shigusa/project/export.hpp>

#include "support/exported.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Where the file's nodes are by assimp's reading of hierarchy and motion.
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
    return export_candidate(task_, candidate_, ExportFormat::bvh).value();
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

}  // namespace
}  // namespace shigusa
