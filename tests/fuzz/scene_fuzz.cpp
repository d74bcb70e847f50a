// SPDX-License-Identifier: MIT
// From the bytes of a glTF or GLB file to the obstacles and things of a scene: no crash, hang or
// memory exhaustion, few boxes, and every number stays finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/scene.hpp>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto scene = parse_scene(bytes, "fuzz.glb", {.things = {"cup", "node_0", "joint"}});
  if (!scene) return 0;
  if (scene->obstacles.size() > kSceneBoxesMax || scene->things.size() > 3) std::abort();
  const auto check = [](const Vec3d& at, const Vec3d& sides) {
    if (!is_finite(at.x + at.y + at.z + sides.x + sides.y + sides.z)) std::abort();
    if (sides.x < 0.0 || sides.y < 0.0 || sides.z < 0.0) std::abort();
  };
  for (const Obstacle& obstacle : scene->obstacles) {
    check(obstacle.position, obstacle.size);
    if (!is_unit(obstacle.rotation)) std::abort();
  }
  for (const Thing& thing : scene->things) {
    check(thing.position, thing.size);
    check(thing.centre, {thing.mass, 0.0, 0.0});
    if (thing.handle) check(thing.handle->position, {});
  }
  return 0;
}
