// SPDX-License-Identifier: MIT
#include "hdf5_source.hpp"

namespace shigusa::hdf5 {

Source::Source(Descriptor file, std::uint64_t begin) : file_(std::move(file)), begin_(begin) {
  const std::uint64_t end = go_to_end(file_).value_or(0);
  if (end > begin) size_ = end - begin;
}

std::optional<std::string> Source::bytes(std::uint64_t at, std::uint64_t size) const {
  if (at > size_ || size > size_ - at) return std::nullopt;
  if (!file_) return bytes_.substr(at, size);
  std::string part(size, '\0');
  if (!read_at(file_, begin_ + at, part.data(), part.size())) return std::nullopt;
  return part;
}

}  // namespace shigusa::hdf5
