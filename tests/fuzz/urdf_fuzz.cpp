// SPDX-License-Identifier: MIT
// From the text of a URDF file to a body that stands: nothing may crash, hang or fill the memory,
// and every number stays finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/io/urdf.hpp>
#include <shigusa/kinematics/forward_kinematics.hpp>
#include <shigusa/rollout/settled_posture.hpp>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const auto robot =
      parse_urdf(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.urdf");
  if (!robot) return 0;
  for (const Transformd& x : robot_places(*robot)) {
    if (!is_finite(x.translation.x + x.translation.y + x.translation.z)) std::abort();
  }
  const auto map = find_humanoid(*robot);
  if (!map) return 0;
  const auto body = build_robot(*robot, *map);
  if (!body) return 0;
  std::vector<std::string> doubts;
  for (const double angle : settled_posture(*body, doubts)) {
    if (!is_finite(angle)) std::abort();
  }
  return 0;
}
