// SPDX-License-Identifier: MIT
// From the text of a URDF file to a standing body: no crash, hang or memory exhaustion, and every
// number stays finite.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/urdf.hpp"
#include "robot_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto reduced = reduced_urdf(text, "fuzz.urdf")) {
    // the text kept in results is read again
    const std::string kept = write_xml(*reduced);
    const auto again = reduced_urdf(kept, "fuzz.urdf");
    if (!again || write_xml(*again) != kept) std::abort();
  }
  if (auto robot = parse_urdf(text, "fuzz.urdf")) check_robot(std::move(*robot));
  return 0;
}
