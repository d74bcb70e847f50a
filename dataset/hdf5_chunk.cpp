// SPDX-License-Identifier: MIT
#include <zlib.h>

#include "hdf5_reader.hpp"

namespace shigusa::hdf5 {
namespace {

constexpr std::size_t kSumBytes = 4;

// Inflates bytes to a known size; empty if the size differs.
std::optional<std::string> inflated(const std::string& packed, std::size_t size) {
  std::string bytes(size, '\0');
  uLongf made = size;
  const auto* from = reinterpret_cast<const Bytef*>(packed.data());
  const int end = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &made, from, packed.size());
  if (end != Z_OK || made != size) return std::nullopt;
  return bytes;
}

// Reverses the shuffle filter, which groups the first bytes of all elements, then the second ones,
// ….
std::string unshuffled(const std::string& bytes, std::size_t element) {
  const std::size_t count = bytes.size() / element;
  std::string together = bytes;
  for (std::size_t part = 0; part < element; ++part) {
    const char* const from = bytes.data() + part * count;
    for (std::size_t k = 0; k < count; ++k) together[k * element + part] = from[k];
  }
  return together;
}

}  // namespace

// Decodes a chunk of `size` bytes. Checksums are skipped: the whole file has one.
Result<std::string> Reader::unpacked(const Chunk& chunk, const Object& object,
                                     std::size_t size) const {
  std::optional<std::string> bytes = source_.bytes(chunk.address, chunk.size);
  if (!bytes) return foreign("a chunk is not there");
  for (std::size_t k = object.filters.size(); k-- > 0;) {
    if ((chunk.left_out >> k & 1) != 0) continue;
    switch (object.filters[k]) {
      case Filter::sum:
        if (bytes->size() < kSumBytes) return foreign("a chunk has no sum");
        bytes->resize(bytes->size() - kSumBytes);
        break;
      case Filter::deflate:
        bytes = inflated(*bytes, size);
        if (!bytes) return foreign("a chunk is packed otherwise");
        break;
      case Filter::shuffle:
        bytes = unshuffled(*bytes, object.form->size);
        break;
    }
  }
  if (bytes->size() != size) return foreign("a chunk has another size");
  return *std::move(bytes);
}

}  // namespace shigusa::hdf5
