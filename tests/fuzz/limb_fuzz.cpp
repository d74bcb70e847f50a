// SPDX-License-Identifier: MIT
// From the bytes of a stored limb library to cells: no crash, hang or memory exhaustion, and
// accepted bytes form a library again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/human.hpp>
#include <string_view>

#include "paper/limb_library.hpp"
#include "plan/layer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  static const PosedBody posed = half_body();
  static const PosedBody arm =
      arm_body(posed.body, posed.home, find_limbs(posed.body, posed.home).value().arms[0]);
  LimbLibrary library(arm);
  if (!library.take(std::string_view(reinterpret_cast<const char*>(data), size))) {
    if (library.cells_built() != 0) std::abort();
    return 0;
  }
  LimbLibrary again(arm);
  if (!again.take(library.bytes()) || again.bytes() != library.bytes()) std::abort();
  return 0;
}
