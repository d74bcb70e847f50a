// SPDX-License-Identifier: MIT
// From the bytes of a BVH file to a measured person: no crash, hang or memory exhaustion, and the
// result can be written and read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/formats.hpp>
#include <shigusa/human.hpp>
#include <string_view>

#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto motion = parse_bvh(text, "fuzz.bvh");
  // a file that is read without tolerance for faults is also read with it
  if (!parse_bvh_file(text, "fuzz.bvh", BvhFaults::told) && motion) std::abort();
  if (!motion) return 0;

  // written in the unit of the file, so that no number exceeds the limits
  const auto again = parse_bvh(format_bvh(*motion, {.unit = 1.0}), "written.bvh");
  if (!again || again->skeleton.nodes.size() != motion->skeleton.nodes.size()) std::abort();

  const auto world = world_transforms(motion->skeleton, motion->clip, 0);
  const auto map = find_humanoid(motion->skeleton, world);
  if (!map) return 0;
  const auto person = measure_person(motion->skeleton, world, *map);
  if (!person) return 0;
  const Landmarks& l = person->landmarks;
  for (const Vec3d& p : {l.left_leg.toe, l.right_leg.toe, l.left_arm.fingertip, l.head_top}) {
    if (!is_finite(p.x + p.y + p.z)) std::abort();
  }
  return 0;
}
