// SPDX-License-Identifier: MIT
// From the bytes of an FBX file through glTF to a measured person: no crash, hang or memory
// exhaustion, and every number stays finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/human.hpp>
#include <string_view>

#include "formats/fbx.hpp"
#include "formats/gltf.hpp"
#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const auto glb =
      glb_of_fbx(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.fbx");
  if (!glb) return 0;
  const auto file = parse_gltf(*glb, "fuzz.fbx");
  if (!file) return 0;
  const Skeleton& skeleton = file->rest.skeleton;
  const auto world = world_transforms(skeleton, file->rest.clip, 0);
  for (const Transformd& x : world) {
    if (!is_finite(x.translation.x + x.translation.y + x.translation.z)) std::abort();
  }
  const auto map = find_humanoid(skeleton, world);
  if (!map) return 0;
  const auto person = measure_person(skeleton, world, *map);
  if (person && !is_finite(person->stature)) std::abort();
  return 0;
}
