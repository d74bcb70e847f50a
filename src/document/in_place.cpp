// SPDX-License-Identifier: MIT
#include "in_place.hpp"

#include "core/index.hpp"
#include "math/axes.hpp"
#include "math/linear_map.hpp"

namespace shigusa {

std::vector<Vec3d> stay_in_place(int node, const Mat3d& parent, const Vec3d& up, std::size_t nodes,
                                 std::vector<LocalTransform>& local) {
  std::vector<Vec3d> ways;
  const auto back = inverse_of(parent);
  if (!back) return ways;  // a file that scales by 0 shows nothing
  const std::size_t first = index(node);
  const Vec3d from = local[first].translation;
  for (std::size_t i = first; i < local.size(); i += nodes) {
    const Vec3d way = parent * (local[i].translation - from);
    const Vec3d along = way - up * dot(way, up);
    local[i].translation = local[i].translation - *back * along;
    ways.push_back(along);
  }
  return ways;
}

std::vector<Vec3d> stay_in_place(const Rig& rig, RigMotion& motion) {
  const int hips = rig.bones[HumanoidBone::hips];
  Mat3d parent{};
  for (int i = rig.nodes[index(hips)].parent; i >= 0; i = rig.nodes[index(i)].parent) {
    const Quatd& turn = motion.local[index(i)].rotation;
    parent = scaled_columns(to_matrix(turn), rig.nodes[index(i)].scale) * parent;
  }
  // motions of mirrored rigs are in the axes of their file
  const Vec3d up = rig.placement.mirrored() ? rig.placement.up : Vec3d{0, 1, 0};
  return stay_in_place(hips, parent, up, rig.nodes.size(), motion.local);
}

}  // namespace shigusa
