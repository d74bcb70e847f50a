// SPDX-License-Identifier: MIT
// From the bytes of a glTF, GLB or VRM file to its mesh, to a measured person, to the file with a
// new animation, and to its own animation: no crash, hang or memory exhaustion, and every number
// stays finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/human.hpp>
#include <span>
#include <string_view>

#include "formats/gltf_animation.hpp"
#include "formats/gltf_skin.hpp"
#include "formats/gltf_write.hpp"
#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  // asked for before the file is parsed
  (void)gltf_animation_names(bytes, "fuzz.glb");
  const auto file = parse_gltf(bytes, "fuzz.glb");
  if (!file) return 0;

  const Skeleton& skeleton = file->rest.skeleton;
  if (file->file_node.size() != skeleton.nodes.size()) std::abort();
  const auto world = world_transforms(skeleton, file->rest.clip, 0);
  for (const Transformd& x : world) {
    if (!is_finite(x.translation.x + x.translation.y + x.translation.z)) std::abort();
  }
  // a readable file can be written, or a reason is given
  const GltfAnimation animation{
      "fuzz", 0.5, 2, {{file->file_node[0], file->places[0], {{}, {}}, {{}, {}}}}};
  if (const auto written = add_animations(bytes, "fuzz.glb", std::span(&animation, 1))) {
    if (!parse_gltf(*written, "written.glb")) std::abort();
  }

  if (const auto moving = parse_gltf_animation(bytes, "fuzz.glb")) {
    const SkeletonClip& clip = moving->motion.clip;
    if (clip.local.size() != skeleton.nodes.size() * static_cast<std::size_t>(clip.frames)) {
      std::abort();
    }
    for (const LocalTransform& local : clip.local) {
      const Vec3d& at = local.translation;
      const Quatd& q = local.rotation;
      if (!is_finite(at.x + at.y + at.z + q.x + q.y + q.z + q.w)) std::abort();
    }
  }

  if (const auto bound = gltf_bind_pose(bytes, "fuzz.glb", *file)) {
    if (bound->local.size() != skeleton.nodes.size()) std::abort();
    if (bound->places.size() != skeleton.nodes.size()) std::abort();
    for (const LocalTransform& local : bound->local) {
      const Vec3d& at = local.translation;
      const Quatd& q = local.rotation;
      if (!is_finite(at.x + at.y + at.z + q.x + q.y + q.z + q.w)) std::abort();
    }
  }

  const Skin skin = read_gltf_skin(bytes, "fuzz.glb", *file, file->places);
  for (const SkinVertex& vertex : skin.vertices) {
    const Vec3d& at = vertex.position;
    if (!is_finite(at.x + at.y + at.z)) std::abort();
    if (vertex.node >= static_cast<int>(skeleton.nodes.size())) std::abort();
  }

  const auto map = find_humanoid(skeleton, world, file->humanoid, {}, skin.vertices);
  if (!map) return 0;
  const auto person = measure_person(skeleton, world, *map, {.stature = {}, .skin = skin.vertices});
  if (!person) return 0;
  const Landmarks& l = person->landmarks;
  for (const Vec3d& p : {l.left_leg.toe, l.right_leg.toe, l.left_arm.fingertip, l.head_top}) {
    if (!is_finite(p.x + p.y + p.z)) std::abort();
  }
  for (const auto& shape : l.parts.shape) {
    if (shape && !(shape->radius > 0.0 && is_finite(shape->radius))) std::abort();
  }
  return 0;
}
