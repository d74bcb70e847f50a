// SPDX-License-Identifier: MIT
#include "kinematics/skeleton_motion.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr int kFrames = 20;

PosedBody character() {
  return build_human(asymmetric_person(), {"character", BodyExtent::full, 1.6, 55.0, Sex::female});
}

Clip random_clip(const BodyModel& body) {
  Random random(5);
  Clip clip{.dofs = body.dof_count(), .frames = kFrames, .frame_time = 0.02, .angles = {}};
  for (int f = 0; f < kFrames; ++f) {
    const std::vector<double> q = random_vector(body, -3.0, 3.0, random);
    clip.angles.insert(clip.angles.end(), q.begin(), q.end());
  }
  return clip;
}

TEST(SkeletonMotion, PutsEachNodeWhereTheBodyHasIt) {
  for (const BodyModel& body : {half_body().body, full_body().body, character().body}) {
    const Clip clip = random_clip(body);
    const SkeletonMotion motion = skeleton_motion(body, clip);
    for (int f = 0; f < kFrames; ++f) {
      const Kinematics<double> kinematics = placed(body, clip.frame(f));
      const std::vector<Transformd> world = world_transforms(motion.skeleton, motion.clip, f);
      ASSERT_EQ(world.size(), body.nodes().size());
      for (std::size_t i = 0; i < world.size(); ++i) {
        const BodyNode& node = body.nodes()[i];
        // a chain of some ten frames of about 1 m, each exact to rounding
        ASSERT_LT(norm(world[i].translation - kinematics.point(node.link, node.point)), 1e-14);
        ASSERT_LT(distance(world[i].rotation, kinematics.link_rotation(node.link)), 1e-14);
      }
    }
  }
}

TEST(SkeletonMotion, KeepsFramesAndTheirTime) {
  const BodyModel body = half_body();
  const SkeletonMotion motion = skeleton_motion(body, random_clip(body));
  EXPECT_EQ(motion.clip.frames, kFrames);
  EXPECT_EQ(motion.clip.frame_time, 0.02);
  EXPECT_EQ(motion.clip.local.size(), kFrames * motion.skeleton.nodes.size());
}

TEST(SkeletonMotion, BonesKeepTheirLength) {
  const BodyModel body = character();
  const SkeletonMotion motion = skeleton_motion(body, random_clip(body));
  for (int f = 0; f < kFrames; ++f) {
    for (std::size_t i = 0; i < motion.skeleton.nodes.size(); ++i) {
      if (motion.skeleton.nodes[i].parent < 0) continue;
      EXPECT_EQ(motion.clip.frame(motion.skeleton, f)[i].translation,
                motion.skeleton.nodes[i].offset);
    }
  }
}

TEST(SkeletonMotion, EffectorsAndFeetAreNodesOfTheSkeleton) {
  for (const BodyModel& body : {half_body().body, full_body().body, character().body}) {
    const Skeleton skeleton = body_skeleton(body);
    Random random(6);
    const Kinematics<double> kinematics = placed(body, random_posture(body, random));
    for (const Effector& effector : body.effectors()) {
      const int node = skeleton.find(effector.node);
      ASSERT_GE(node, 0) << effector.node;
      const BodyNode& at = body.nodes()[static_cast<std::size_t>(node)];
      EXPECT_LT(norm(kinematics.point(at.link, at.point) -
                     kinematics.point(effector.link, effector.point)),
                1e-15);
    }
    for (const Foot& foot : body.feet()) EXPECT_GE(skeleton.find(foot.node), 0) << foot.node;
  }
}

TEST(BodySkeleton, RestIsTheBodyWithAllAnglesZero) {
  const BodyModel body = character();
  const Skeleton skeleton = body_skeleton(body);
  const Kinematics<double> kinematics = placed(body, std::vector<double>(body.dofs().size(), 0.0));
  std::vector<Vec3d> rest;
  for (std::size_t i = 0; i < skeleton.nodes.size(); ++i) {
    const SkeletonNode& node = skeleton.nodes[i];
    const bool root = node.parent < 0;
    const Vec3d offset = root ? node.offset : kinematics.base_rotation * node.offset;
    rest.push_back(root ? offset : rest[static_cast<std::size_t>(node.parent)] + offset);
    const BodyNode& expected = body.nodes()[i];
    EXPECT_LT(norm(rest[i] - kinematics.point(expected.link, expected.point)), 1e-14);
  }
}

}  // namespace
}  // namespace shigusa
