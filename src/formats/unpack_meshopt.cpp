// SPDX-License-Identifier: MIT
#include <meshoptimizer.h>

#include <array>

#include "core/say.hpp"
#include "unpack.hpp"

namespace shigusa {
namespace {

struct Mode {
  std::string_view name;
  int (*unpack)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
  std::size_t strides;  // bit n: of n bytes …
  bool of_words;        // … or of words, 64 at most
  unsigned newest;      // version that the library of Debian 12 reads
};
constexpr std::array kModes{
    Mode{"ATTRIBUTES", &meshopt_decodeVertexBuffer, 0, true, 0},
    Mode{"TRIANGLES", &meshopt_decodeIndexBuffer, 1 << 2 | 1 << 4, false, 1},
    Mode{"INDICES", &meshopt_decodeIndexSequence, 1 << 2 | 1 << 4, false, 1}};

struct Filter {
  std::string_view name;
  void (*apply)(void*, std::size_t, std::size_t);
  std::size_t strides;
  bool of_words;
};
constexpr std::array kFilters{
    Filter{"OCTAHEDRAL", &meshopt_decodeFilterOct, 1 << 4 | 1 << 8, false},
    Filter{"QUATERNION", &meshopt_decodeFilterQuat, 1 << 8, false},
    Filter{"EXPONENTIAL", &meshopt_decodeFilterExp, 0, true}};

// Table row of this name that supports this stride; the library itself does not check.
template <class Row, std::size_t N>
const Row* row_of(const std::array<Row, N>& rows, std::string_view name, std::size_t stride) {
  for (const Row& row : rows) {
    const bool fits = row.of_words ? stride > 0 && stride % 4 == 0 && stride <= 256
                                   : stride <= 8 && (row.strides >> stride & 1) != 0;
    if (row.name == name && fits) return &row;
  }
  return nullptr;
}

}  // namespace

Result<std::string> unpack_meshopt(const MeshoptView& view, std::string_view packed,
                                   const std::string& place) {
  const Mode* mode = row_of(kModes, view.mode, view.stride);
  const bool filtered = !view.filter.empty() && view.filter != "NONE";
  const Filter* filter = filtered ? row_of(kFilters, view.filter, view.stride) : nullptr;
  const bool known = mode != nullptr && (!filtered || (filter != nullptr && mode->of_words)) &&
                     (view.mode != "TRIANGLES" || view.count % 3 == 0);
  if (!known) {
    return fail(ErrorCode::parse,
                say("meshopt_mode", view.mode, view.count, view.stride,
                    filtered ? std::string_view(view.filter) : "NONE"),
                place);
  }
  if (view.count > kUnpackedMaxBytes / view.stride) {
    return fail(ErrorCode::parse, say("unpacked_bytes", kUnpackedMaxBytes), place);
  }
  std::string bytes(view.count * view.stride, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
  if (mode->unpack(bytes.data(), view.count, view.stride, from, packed.size()) != 0) {
    // the low half of the first byte is the version of the remaining data
    const unsigned version = packed.empty() ? 0U : from[0] & 15U;
    return fail(ErrorCode::parse,
                version > mode->newest ? say("meshopt_version", version, mode->newest)
                                       : say("packed_damaged"),
                place);
  }
  if (filter != nullptr) filter->apply(bytes.data(), view.count, view.stride);
  return bytes;
}

}  // namespace shigusa
