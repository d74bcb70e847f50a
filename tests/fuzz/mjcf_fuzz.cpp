// SPDX-License-Identifier: MIT
// From the text of an MJCF file, which may include itself, through URDF to a standing body: no
// crash, hang or memory exhaustion, every number stays finite, and URDF made by one reader is
// accepted by the other.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "formats/mjcf.hpp"
#include "formats/urdf.hpp"
#include "robot_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto robot =
      parse_mjcf(text, "fuzz.xml", [&](const std::string&) { return std::string(text); });
  if (!robot) return 0;
  auto again = parse_urdf(write_urdf(*robot), "fuzz.urdf");
  if (!again || again->links.size() != robot->links.size()) std::abort();
  check_robot(std::move(*again));
  return 0;
}
