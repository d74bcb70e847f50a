// SPDX-License-Identifier: MIT
#include "hdf5_source.hpp"

#include <unistd.h>

namespace shigusa::hdf5 {

Source::Source(Descriptor file, std::uint64_t begin) : file_(std::move(file)), begin_(begin) {
  const off_t end = lseek(file_.number(), 0, SEEK_END);
  if (end > 0 && static_cast<std::uint64_t>(end) > begin) {
    size_ = static_cast<std::uint64_t>(end) - begin;
  }
}

std::optional<std::string> Source::bytes(std::uint64_t at, std::uint64_t size) const {
  if (at > size_ || size > size_ - at) return std::nullopt;
  if (!file_) return bytes_.substr(at, size);
  std::string part(size, '\0');
  for (std::size_t read = 0; read < part.size();) {
    const ssize_t more = pread(file_.number(), part.data() + read, part.size() - read,
                               static_cast<off_t>(begin_ + at + read));
    if (more <= 0) return std::nullopt;
    read += static_cast<std::size_t>(more);
  }
  return part;
}

}  // namespace shigusa::hdf5
