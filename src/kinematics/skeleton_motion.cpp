// SPDX-License-Identifier: MIT
#include "kinematics/skeleton_motion.hpp"

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

Skeleton body_skeleton(const BodyModel& body) {
  const std::vector<double> zero(body.dofs().size(), 0.0);
  Kinematics<double> kinematics(body);
  forward_kinematics<double>(body, zero, kinematics);
  Skeleton skeleton;
  std::vector<Vec3d> world;
  for (const BodyNode& node : body.nodes()) {
    const Vec3d at = kinematics.point(node.link, node.point);
    // at rest all frames have the base's orientation, in which a node's offset is expressed
    const Vec3d from = node.parent < 0 ? Vec3d{} : world[static_cast<std::size_t>(node.parent)];
    const Vec3d offset =
        node.parent < 0 ? at : transpose_times(kinematics.base_rotation, at - from);
    skeleton.nodes.push_back({node.name, node.parent, offset, node.end_site});
    world.push_back(at);
  }
  return skeleton;
}

SkeletonMotion skeleton_motion(const BodyModel& body, const Clip& clip) {
  SkeletonMotion motion{body_skeleton(body), {}};
  motion.clip.frame_time = clip.frame_time;
  motion.clip.frames = clip.frames;
  motion.clip.local.reserve(static_cast<std::size_t>(clip.frames) * body.nodes().size());
  Kinematics<double> kinematics(body);
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), kinematics);
    for (std::size_t i = 0; i < body.nodes().size(); ++i) {
      const BodyNode& node = body.nodes()[i];
      const Mat3d& rotation = kinematics.link_rotation(node.link);
      if (node.parent < 0) {
        motion.clip.local.push_back({kinematics.point(node.link, node.point), to_quat(rotation)});
        continue;
      }
      const BodyNode& parent = body.nodes()[static_cast<std::size_t>(node.parent)];
      const Mat3d relative = transpose(kinematics.link_rotation(parent.link)) * rotation;
      motion.clip.local.push_back({motion.skeleton.nodes[i].offset, to_quat(relative)});
    }
  }
  return motion;
}

}  // namespace shigusa
