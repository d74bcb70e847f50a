// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// Limit on the unpacked bytes of one file.
inline constexpr std::size_t kUnpackedMaxBytes = std::size_t{512} << 20;

// Storage type of an accessor's component.
struct AccessorComponent {
  std::size_t bytes = 4;
  double largest = 0.0;  // integer that stands for 1 if normalised; 0: a float
  bool has_sign = true;
};

// Packing of a buffer view by EXT_meshopt_compression or KHR_meshopt_compression.
struct MeshoptView {
  std::size_t count = 0;   // of elements
  std::size_t stride = 0;  // bytes of each, unpacked
  std::string mode;        // ATTRIBUTES, TRIANGLES, INDICES
  std::string filter;      // NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

// Unpacked bytes of a view: count x stride. Fails on damaged data, and on a version that the
// library does not support. `place` stands for the view in errors.
[[nodiscard]] Result<std::string> unpack_meshopt(const MeshoptView& view, std::string_view packed,
                                                 const std::string& place);

// Values requested of a mesh in KHR_draco_mesh_compression.
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

// Memory taken for unpacked data is subtracted from `room` (bytes); fails beforehand if it would be
// exceeded.
[[nodiscard]] Result<DracoMesh> unpack_draco(std::string_view packed,
                                             std::span<const DracoAttribute> attributes,
                                             std::size_t& room, const std::string& place);

}  // namespace shigusa
