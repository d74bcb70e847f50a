// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The bytes that the packed parts of one file may unpack to.
inline constexpr std::size_t kUnpackedMaxBytes = std::size_t{512} << 20;

// How a component of an accessor is stored.
struct AccessorComponent {
  std::size_t bytes = 4;
  double largest = 0.0;  // of a normalised integer what stands for 1; 0: a float
  bool has_sign = true;
};

// How EXT_meshopt_compression or KHR_meshopt_compression packs a buffer view.
struct MeshoptView {
  std::size_t count = 0;   // of elements
  std::size_t stride = 0;  // bytes of each, unpacked
  std::string mode;        // ATTRIBUTES, TRIANGLES, INDICES
  std::string filter;      // NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

// The bytes of a view: count x stride of them. Fails for what is damaged, and for what a version
// packs that the library does not know. `place` stands for the view in errors.
[[nodiscard]] Result<std::string> unpack_meshopt(const MeshoptView& view, std::string_view packed,
                                                 const std::string& place);

// Values of a mesh of KHR_draco_mesh_compression that are asked for.
struct DracoAttribute {
  std::uint32_t id = 0;  // in the mesh
  int components = 0;
  AccessorComponent kind;
};

struct DracoMesh {
  std::size_t points = 0;
  std::vector<std::string> columns;  // (attributes) little-endian, one point after the other
  std::string corners;               // (triangles x 3) of 32 bits
};

// Takes what it unpacks to from `room`, in bytes, and fails before more than that is taken.
[[nodiscard]] Result<DracoMesh> unpack_draco(std::string_view packed,
                                             std::span<const DracoAttribute> attributes,
                                             std::size_t& room, const std::string& place);

}  // namespace shigusa
