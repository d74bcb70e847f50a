// SPDX-License-Identifier: MIT
#include "robot/root_joints.hpp"

#include "math/ldlt.hpp"
#include "math/turn_about.hpp"

namespace shigusa {
namespace {

constexpr int kJoints = 6;

// Placement of the root by the joints, and its derivatives by each of them.
struct Carried {
  Transformd root;
  std::array<Vec3d, 6> moves;  // m per unit, of the root's origin
  std::array<Vec3d, 6> turns;  // rad per unit
};

Carried carried(const RobotFrame& robot, const RootValues& values) {
  Carried result{robot.world, {}, {}};
  std::array<Vec3d, 6> at{};
  for (std::size_t k = 0; k < kJoints; ++k) {
    const RootJoint& joint = robot.carriers[k];
    result.root = result.root * joint.origin;
    const Vec3d axis = result.root.rotation * joint.axis;
    at[k] = result.root.translation;
    if (joint.slides) {
      result.root.translation += axis * values[k];
      result.moves[k] = axis;
    } else {
      result.root.rotation = turn_about(axis, values[k]) * result.root.rotation;
      result.turns[k] = axis;
    }
  }
  for (std::size_t k = 0; k < kJoints; ++k) {
    if (robot.carriers[k].slides) continue;
    result.moves[k] = cross(result.turns[k], result.root.translation - at[k]);
  }
  return result;
}

// Small rotation from one frame to another, as a vector; exact at zero.
Vec3d turn_between(const Mat3d& from, const Mat3d& to) {
  return (cross(from.cx, to.cx) + cross(from.cy, to.cy) + cross(from.cz, to.cz)) * 0.5;
}

}  // namespace

std::optional<RootValues> root_values(const RobotFrame& robot, const Transformd& root,
                                      RootValues begin) {
  constexpr int kSteps = 60;
  constexpr double kNear = 1e-10;  // m, rad
  constexpr double kDamping = 1e-12;
  if (robot.carriers.size() != kJoints) return std::nullopt;
  RootValues values = begin;
  for (int step = 0; step < kSteps; ++step) {
    const Carried now = carried(robot, values);
    const Vec3d move = root.translation - now.root.translation;
    const Vec3d turn = turn_between(now.root.rotation, root.rotation);
    const bool same_way = dot(now.root.rotation.cx, root.rotation.cx) > 0.0 &&
                          dot(now.root.rotation.cy, root.rotation.cy) > 0.0;
    if (same_way && norm(move) < kNear && norm(turn) < kNear) return values;
    SmallSymmetric<double, kJoints> normal{};
    RootValues change{};
    for (std::size_t i = 0; i < kJoints; ++i) {
      change[i] = dot(now.moves[i], move) + dot(now.turns[i], turn);
      for (std::size_t j = 0; j <= i; ++j) {
        normal(static_cast<int>(i), static_cast<int>(j)) = dot(now.moves[i], now.moves[j]) +
                                                           dot(now.turns[i], now.turns[j]) +
                                                           (i == j ? kDamping : 0.0);
      }
    }
    ldlt_solve(normal, change.data(), kJoints, 0.0);
    for (std::size_t k = 0; k < kJoints; ++k) values[k] += change[k];
  }
  return std::nullopt;
}

}  // namespace shigusa
