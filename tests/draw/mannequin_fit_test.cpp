// SPDX-License-Identifier: MIT
// The mannequin's skin: undamaged, and fitted to the bones of other people.
#include "draw/mannequin_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/human.hpp>

#include "draw/mannequin.hpp"
#include "kinematics/skeleton_motion.hpp"

namespace shigusa {
namespace {

TEST(MannequinMesh, HalvesShareTheSeamAndAreMirrorImages) {
  const MannequinMesh& mesh = mannequin_mesh();
  const auto less = [](const Vec3d& a, const Vec3d& b) {
    return std::tuple{a.x, a.y, a.z} < std::tuple{b.x, b.y, b.z};
  };
  std::vector<Vec3d> left;
  std::vector<Vec3d> right;
  for (const Vec3d& p : mesh.positions) {
    if (p.x > 0.0) left.push_back(p);
    if (p.x < 0.0) right.push_back({-p.x, p.y, p.z});
  }
  std::sort(left.begin(), left.end(), less);
  std::sort(right.begin(), right.end(), less);
  EXPECT_EQ(left, right);
  EXPECT_GT(mesh.positions.size(), left.size() + right.size());
  // an edge of one triangle alone is where the skin is cut; the seam is none
  std::map<std::pair<int, int>, int> triangles;
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    const int a = mesh.corners[k];
    const int b = mesh.corners[k % 3 == 2 ? k - 2 : k + 1];
    ++triangles[std::minmax(a, b)];
  }
  for (const auto& [edge, count] : triangles) {
    const bool on_seam = mesh.positions[static_cast<std::size_t>(edge.first)].x == 0.0 &&
                         mesh.positions[static_cast<std::size_t>(edge.second)].x == 0.0;
    EXPECT_TRUE(!on_seam || count == 2) << edge.first;
  }
}

// A person with limbs of other lengths than the mannequin's, and the left arm straight up.
class FittedSkin : public testing::Test {
 protected:
  FittedSkin() {
    Clip clip{.dofs = body_.body.dof_count(), .frames = 1, .angles = {}};
    clip.angles.assign(body_.home.angles.begin(), body_.home.angles.end());
    skeleton_ = skeleton_motion(body_, clip).skeleton;
    for (SkeletonNode& node : skeleton_.nodes) {
      for (const auto& [part, by] : {std::pair{"lower_arm", 1.2},
                                     {"hand", 0.8},
                                     {"lower_leg", 1.1},
                                     {"toes", 1.3},
                                     {"hand_grip", 1.25},
                                     {"head", 1.2}}) {
        if (without_side(node.name) == part) node.offset = node.offset * by;
      }
    }
    const Vec3d up = RestBones(skeleton_).axes().cy;
    for (const char* name : {"left_lower_arm", "left_hand", "left_hand_grip"}) {
      SkeletonNode& node = skeleton_.nodes[static_cast<std::size_t>(skeleton_.find(name))];
      node.offset = up * norm(node.offset);
    }
  }
  static std::string_view without_side(std::string_view name) {
    for (const std::string_view side : {"left_", "right_"}) {
      if (name.starts_with(side)) return name.substr(side.size());
    }
    return name;
  }
  // Where a bone of the mesh begins there.
  static Vec3d made(const std::string& name) {
    const auto& bones = mannequin_mesh().bones;
    return std::find_if(bones.begin(), bones.end(), [&](const auto& b) { return b.name == name; })
        ->place;
  }

  PosedBody body_ = human_body();
  Skeleton skeleton_;
};

TEST_F(FittedSkin, OfALimbReachesFromItsJointToTheNext) {
  const RestBones bones(skeleton_);
  const SkinFitter fitter(bones, mannequin_mesh(), 1.7);
  for (const std::string side : {"left_", "right_"}) {
    for (const auto& [bone, next] : {std::pair{"upper_arm", "lower_arm"},
                                     {"lower_arm", "hand"},
                                     {"upper_leg", "lower_leg"},
                                     {"lower_leg", "foot"},
                                     {"foot", "toes"}}) {
      const SkinFit fit = fitter.of(side + bone);
      EXPECT_EQ(fit.bone, side + bone);
      EXPECT_LT(norm(fit.place * made(side + bone) - *bones.at(side + bone)), 1e-9) << bone;
      EXPECT_LT(norm(fit.place * made(side + next) - *bones.at(side + next)), 1e-3) << bone;
    }
    EXPECT_LT(norm(fitter.of(side + "toes").place * made(side + "toes") - *bones.at(side + "toes")),
              1e-9);
  }
  EXPECT_LT(norm(fitter.of("neck").place * made("head") - *bones.at("head")), 0.03);
}

TEST_F(FittedSkin, OfALimbThatIsNotThereShrinksIntoItsJoint) {
  for (SkeletonNode& node : skeleton_.nodes) {
    if (node.name.starts_with("left_")) node.name = "no " + node.name;
  }
  const RestBones bones(skeleton_);
  const SkinFitter fitter(bones, mannequin_mesh(), 1.7);
  for (const auto& [gone, carrier, root, tip] :
       {std::array{"lower_leg", "hips", "upper_leg", "toes"},
        {"foot", "hips", "upper_leg", "toes"},
        {"toes", "hips", "upper_leg", "toes"},
        {"lower_arm", "upper_chest", "upper_arm", "hand"},
        {"hand", "upper_chest", "upper_arm", "hand"}}) {
    const SkinFit fit = fitter.of(std::string("left_") + gone);
    EXPECT_EQ(fit.bone, carrier);
    const Vec3d begin = fit.place * made(std::string("left_") + root);
    EXPECT_LT(norm(fit.place * made(std::string("left_") + tip) - begin), 2e-3) << gone;
  }
}

TEST_F(FittedSkin, IsWhereItWasLaidWhileTheBodyRests) {
  const Mannequin mannequin(skeleton_, mannequin_mesh(), 1.7);
  const std::size_t nodes = mannequin.skeleton().nodes.size();
  ASSERT_EQ(mannequin.rest().size(), nodes);
  ASSERT_EQ(mannequin.inverses().size(), mannequin.joints().size());
  std::vector<Transformd> world;
  for (std::size_t i = 0; i < nodes; ++i) {
    const int parent = mannequin.skeleton().nodes[i].parent;
    const LocalTransform& local = mannequin.rest()[i];
    const Transformd own{to_matrix(local.rotation), local.translation};
    world.push_back(parent < 0 ? own : world[static_cast<std::size_t>(parent)] * own);
  }
  const RestBones bones(skeleton_);
  const SkinFitter fitter(bones, mannequin_mesh(), 1.7);
  const auto& skin = mannequin_mesh().bones;
  for (std::size_t k = 0; k < skin.size(); ++k) {
    if (skin[k].kind != SkinBone::Kind::node) continue;
    const auto joint = static_cast<std::size_t>(mannequin.joints()[k]);
    const Vec3d there = world[joint] * (mannequin.inverses()[k] * skin[k].place);
    EXPECT_LT(norm(there - fitter.of(skin[k].name).place * skin[k].place), 1e-9) << skin[k].name;
  }
}

}  // namespace
}  // namespace shigusa
