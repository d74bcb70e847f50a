// SPDX-License-Identifier: MIT
#include "boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace shigusa::bench {
namespace {

constexpr double kStep = 0.01;  // m, along a bone

// Vector rotated by the inverse of a unit quaternion.
Vec3d turned_back(const Quatd& q, const Vec3d& v) {
  const Vec3d u{-q.x, -q.y, -q.z};
  const Vec3d t = cross(u, v) * 2.0;
  return v + t * q.w + cross(u, t);
}

// Node of the motion for an effector's name, or for its own; or "".
std::string node_for(const BodyModel& body, const OutsideMotion& motion, const std::string& name) {
  if (motion.has(name)) return name;
  const auto effector = body.find_effector(name);
  if (!effector) return "";
  const std::string& node = body.effector(*effector).node;
  return motion.has(node) ? node : "";
}

void add_chain(const BodyModel& body, const OutsideMotion& motion,
               const std::vector<std::string>& names, std::vector<Bone>& bones) {
  std::string last;
  for (const std::string& name : names) {
    const std::string node = node_for(body, motion, name);
    if (node.empty()) continue;
    if (!last.empty()) bones.push_back({last, node});
    last = node;
  }
}

double deepest_on(const Obstacle& obstacle, const Vec3d& from, const Vec3d& to) {
  const int steps = 1 + static_cast<int>(norm(to - from) / kStep);
  double deepest = -1e9;
  for (int k = 0; k <= steps; ++k) {
    const Vec3d point = from + (to - from) * (static_cast<double>(k) / steps);
    deepest = std::fmax(deepest, -distance_from(obstacle, point));
  }
  return deepest;
}

bool rests_there(const Candidate& candidate, const Bone& bone, const std::string& obstacle) {
  return std::any_of(
      candidate.resting.begin(), candidate.resting.end(),
      [&](const RestResult& rest) { return rest.on == obstacle && rest.node == bone.to; });
}

}  // namespace

double distance_from(const Obstacle& obstacle, const Vec3d& point) {
  const Vec3d p = turned_back(obstacle.rotation, point - obstacle.position);
  std::array<double, 3> over{};
  for (int k = 0; k < 3; ++k) {
    over[static_cast<std::size_t>(k)] = std::fabs(p[k]) - 0.5 * obstacle.size[k];
  }
  const double most = *std::max_element(over.begin(), over.end());
  if (most <= 0.0) return most - obstacle.radius;
  double squares = 0.0;
  for (const double o : over) squares += o > 0.0 ? o * o : 0.0;
  return std::sqrt(squares) - obstacle.radius;
}

std::vector<Bone> bones_of(const BodyModel& body, const OutsideMotion& motion) {
  std::vector<Bone> bones;
  const bool robot = body.is_robot();
  for (const std::string side : {"left_", "right_"}) {
    if (robot) {
      add_chain(body, motion, {side + "shoulder", side + "elbow", side + "wrist", side + "hand"},
                bones);
      add_chain(body, motion, {side + "hip", side + "knee", side + "foot"}, bones);
    } else {
      add_chain(body, motion,
                {side + "upper_arm", side + "lower_arm", side + "hand", side + "hand_grip"}, bones);
      add_chain(body, motion,
                {side + "upper_leg", side + "lower_leg", side + "foot", side + "toes"}, bones);
    }
  }
  add_chain(body, motion, {"hips", "spine", "chest", "upper_chest", "neck", "head"}, bones);
  return bones;
}

BoneInBox deepest_bone(const Task& task, const Candidate& candidate, const OutsideMotion& motion,
                       bool resting) {
  BoneInBox deepest;
  if (task.obstacles.empty()) return deepest;
  for (const Bone& bone : bones_of(task.body, motion)) {
    for (const Obstacle& obstacle : task.obstacles) {
      if (rests_there(candidate, bone, obstacle.name) != resting) continue;
      double at_start = 0.0;
      for (std::size_t f = 0; f < motion.frames(); ++f) {
        const double depth = deepest_on(obstacle, motion.at(bone.from, f).translation,
                                        motion.at(bone.to, f).translation);
        if (f == 0) at_start = std::fmax(depth, 0.0);
        if (depth - at_start > deepest.depth) deepest = {depth - at_start, bone, obstacle.name};
      }
    }
  }
  return deepest;
}

}  // namespace shigusa::bench
