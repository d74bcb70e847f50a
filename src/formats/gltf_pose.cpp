// SPDX-License-Identifier: MIT
#include "gltf_pose.hpp"

#include "core/index.hpp"
#include "math/linear_map.hpp"

namespace shigusa {

std::vector<Transformd> placed_nodes(const Skeleton& skeleton, std::span<const GltfPlace> places) {
  std::vector<Transformd> world;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Transformd local = places[i].transform();
    const int parent = skeleton.nodes[i].parent;
    world.push_back(parent < 0 ? local : world[index(parent)] * local);
  }
  return world;
}

std::vector<LocalTransform> turned_from_rest(const Skeleton& skeleton,
                                             const std::vector<Transformd>& resting,
                                             const std::vector<Transformd>& world) {
  std::vector<Mat3d> turned;
  std::vector<LocalTransform> local;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const int parent = skeleton.nodes[i].parent;
    const Mat3d above = parent < 0 ? Mat3d{} : turned[index(parent)];
    const auto back = inverse_of(resting[i].rotation);
    // a node with scale 0 moves with its parent
    const bool flat = !back || !inverse_of(world[i].rotation);
    turned.push_back(flat ? above : orthonormal(world[i].rotation * *back));
    const Vec3d from = parent < 0 ? Vec3d{} : world[index(parent)].translation;
    local.push_back({transpose_times(above, world[i].translation - from),
                     to_quat(transpose(above) * turned.back())});
  }
  return local;
}

GltfPlace parts_of(const Transformd& place) {
  const Mat3d& m = place.rotation;
  const double side = dot(cross(m.cx, m.cy), m.cz) < 0.0 ? -1.0 : 1.0;
  const Vec3d x = normalized(m.cx * side, {1, 0, 0});
  const Vec3d z = normalized(cross(x, m.cy), {0, 0, 1});
  return {place.translation,
          to_quat(Mat3d{x, cross(z, x), z}),
          {side * norm(m.cx), norm(m.cy), norm(m.cz)}};
}

}  // namespace shigusa
