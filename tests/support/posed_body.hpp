// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <shigusa/criteria.hpp>
#include <utility>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "support/bodies.hpp"

// A body for tests of criteria that measure hips, shoulders, hands and ankles: knees, trunk and
// arms move independently, so that a test sets each by itself.
namespace shigusa::testing_support {

inline constexpr double kPosedStature = 2.0;          // m
inline constexpr double kPosedArm = 0.5;              // m, from shoulder to hand
inline constexpr double kPosedLeg = 0.9;              // m, from ankle to hip
inline constexpr double kPosedTrunk = 0.5;            // m, from hips to shoulders
inline constexpr double kPosedShoulders = 0.4;        // m, apart
inline constexpr Vec3d kPosedAnkles{0.0, 0.1, 0.05};  // m, the middle of both

// One frame of its motion.
struct Pose {
  struct Arm {
    Vec3d shoulder{};  // m
    Vec3d hand{};      // m
  };
  double lean = 0.0;  // rad, of the line from hips to shoulders
  double left_knee = 0.0;
  double right_knee = 0.0;
  Arm left{};
  Arm right{};
  Vec3d mass{};  // m, its centre
};

// The definition of the body, in the order of a Pose's angles, then the arms.
inline BodyDefinition posed_definition() {
  BodyDefinition body;
  body.name = "posed";
  body.stature = kPosedStature;
  const Vec3d hips = kPosedAnkles + Vec3d{0, kPosedLeg, 0};
  for (const char* joint : {"trunk", "left_knee", "right_knee"}) {
    body.dofs.push_back(hinge(joint, kBaseLink, hips));
  }
  const Vec3d half{0, -0.5 * kPosedArm, 0};
  for (const std::string side : {"left_", "right_"}) {
    const double out = side == "left_" ? 1.0 : -1.0;
    const auto shoulder = static_cast<int>(body.dofs.size());
    body.dofs.push_back(hinge(side + "shoulder", kBaseLink, {}));
    body.dofs.push_back(hinge(side + "elbow", shoulder, half));
    body.effectors.push_back({side + "hand", side + "hand", shoulder + 1, half, shoulder});
    const auto above_ankle = [out](double height) {
      return kPosedAnkles + Vec3d{0.1 * out, height, 0.0};
    };
    body.nodes.push_back({side + "upper_leg", -1, kBaseLink, above_ankle(kPosedLeg)});
    body.nodes.push_back({side + "lower_leg", -1, kBaseLink, above_ankle(0.5 * kPosedLeg)});
    body.nodes.push_back({side + "foot", -1, kBaseLink, above_ankle(0.0)});
    const Vec3d shoulder_in_trunk{0.5 * kPosedShoulders * out, kPosedTrunk, 0.0};
    body.nodes.push_back({side + "upper_arm", -1, 0, shoulder_in_trunk});
  }
  body.masses.assign(body.dofs.size(), {.mass = 1.0});
  body.mass = static_cast<double>(body.dofs.size());
  return body;
}

inline const PosedBody& posed_body() {
  static const PosedBody body = at_zero(posed_definition());
  return body;
}

// The same without the joints, or nodes, of these names.
inline PosedBody posed_body_without(const std::vector<std::string>& names) {
  BodyDefinition body = posed_definition();
  const auto has = [&names](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (Dof& dof : body.dofs) {
    if (has(dof.joint)) dof.joint = dof.name = "other";
  }
  std::erase_if(body.nodes, [&has](const BodyNode& node) { return has(node.name); });
  return at_zero(std::move(body));
}

// (dofs) rad
inline std::vector<double> angles_of(const BodyModel& body, const Pose& pose) {
  std::vector<double> angles(body.dofs().size(), 0.0);
  const double set[] = {pose.lean, pose.left_knee, pose.right_knee};
  std::copy(std::begin(set), std::end(set), angles.begin());
  return angles;
}

inline Kinematics<double> placed_in(const BodyModel& body, const Pose& pose) {
  Kinematics<double> kinematics = placed(body, angles_of(body, pose));
  for (int e = 0; e < 2; ++e) {
    const Effector& hand = body.effector(e);
    const Pose::Arm& arm = e == 0 ? pose.left : pose.right;
    kinematics.origin[static_cast<std::size_t>(hand.limb_root)] = arm.shoulder;
    kinematics.origin[static_cast<std::size_t>(hand.link)] = arm.hand - hand.point;
  }
  return kinematics;
}

template <class Criterion>
void show_poses(const BodyModel& body, const std::vector<Pose>& poses, Criterion& criterion) {
  for (const Pose& pose : poses) {
    const std::vector<double> angles = angles_of(body, pose);
    const Kinematics<double> kinematics = placed_in(body, pose);
    criterion.add(PlacedFrame<double>{
        {.angles = angles, .torques = {}, .centre_of_mass = pose.mass}, kinematics});
  }
}

// The settings of a criterion in a test.
struct Asked {
  std::optional<double> scale{};  // empty: the usual one
  std::vector<int> effectors{};
  Habit habit{};
};

// A criterion's penalty for a motion through these poses.
template <template <class> class Criterion>
double penalty_of_poses(const std::vector<Pose>& poses, const Asked& asked = {},
                        const PosedBody& body = posed_body()) {
  const double usual = CriteriaSettings()[Criterion<double>::kKind].scale;
  Criterion<double> criterion(
      body, {.start = body.home, .effectors = asked.effectors, .habit = asked.habit},
      asked.scale.value_or(usual));
  show_poses(body, poses, criterion);
  return criterion.penalty();
}

// The mirror image between left and right.
inline Pose mirrored(Pose pose) {
  std::swap(pose.left, pose.right);
  std::swap(pose.left_knee, pose.right_knee);
  for (Vec3d* place :
       {&pose.left.shoulder, &pose.left.hand, &pose.right.shoulder, &pose.right.hand, &pose.mass}) {
    place->x = -place->x;
  }
  return pose;
}

// A motion between two asymmetric postures.
inline std::vector<Pose> lopsided_poses() {
  std::vector<Pose> poses(3);
  poses[0].left = {{0.2, 1.4, 0.0}, {0.25, 0.9, 0.1}};
  poses[0].right = {{-0.2, 1.4, 0.0}, {-0.22, 0.95, 0.05}};
  poses[0].mass = {0.01, 1.0, 0.02};
  poses[1] = poses[0];
  poses[1].right.hand = {-0.3, 0.7, 0.3};
  poses[1].left.hand = {0.35, 1.0, 0.3};
  poses[2] = {.lean = 0.7,
              .left_knee = 0.3,
              .right_knee = 0.5,
              .left = {{0.3, 1.3, 0.1}, {0.5, 1.2, 0.4}},
              .right = {{-0.1, 1.2, 0.2}, {-0.2, 0.4, 0.45}},
              .mass = {0.03, 0.9, 0.06}};
  return poses;
}

// Expects equal penalties above 0 for asymmetric poses and their mirror images.
template <template <class> class Criterion>
void expect_the_same_in_a_mirror(const Asked& asked = {}) {
  std::vector<Pose> poses = lopsided_poses();
  const double penalty = penalty_of_poses<Criterion>(poses, asked);
  EXPECT_GT(penalty, 0.0);
  EXPECT_LT(penalty, 1.0);
  for (Pose& pose : poses) pose = mirrored(pose);
  EXPECT_DOUBLE_EQ(penalty_of_poses<Criterion>(poses, asked), penalty);
}

// Index of the right hand among the effectors, for the settings.
inline std::vector<int> right_hand_of(const BodyModel& body) {
  return {body.find_effector("right_hand").value()};
}

}  // namespace shigusa::testing_support
