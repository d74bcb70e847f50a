// SPDX-License-Identifier: MIT
// From the JSON of a host's nodes to a body: no crash, hang or memory exhaustion.
#include <cstddef>
#include <cstdint>
#include <shigusa/character.hpp>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  CharacterSpec spec{.source = "fuzz.glb"};
  const std::string_view nodes(reinterpret_cast<const char*>(data), size);
  if (load_nodes(nodes, spec)) (void)build_character(spec);
  return 0;
}
