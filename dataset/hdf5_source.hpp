// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "files/descriptor.hpp"

namespace shigusa::hdf5 {

// Bytes of an HDF5 file, addressed from behind the head.
class Source {
 public:
  explicit Source(std::string bytes) : bytes_(std::move(bytes)), size_(bytes_.size()) {}
  // The file from `begin` on.
  Source(Descriptor file, std::uint64_t begin);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  // Bytes of the file; empty if it has fewer.
  [[nodiscard]] std::optional<std::string> bytes(std::uint64_t at, std::uint64_t size) const;

 private:
  std::string bytes_;
  Descriptor file_;
  std::uint64_t begin_ = 0;
  std::uint64_t size_ = 0;
};

// Reads little-endian numbers from bytes; beyond their end they are 0.
class Bytes {
 public:
  explicit Bytes(std::string_view all) : rest_(all) {}

  [[nodiscard]] std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    const std::string_view part = text(size);
    for (std::size_t k = part.size(); k-- > 0;) {
      value = value << 8 | static_cast<unsigned char>(part[k]);
    }
    return value;
  }
  [[nodiscard]] std::string_view text(std::size_t size) {
    if (size > rest_.size()) {
      whole_ = false;
      rest_ = {};
      return {};
    }
    const std::string_view part = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return part;
  }
  void skip(std::size_t size) { (void)text(size); }

  // Whether all reads were within the bytes.
  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  bool whole_ = true;
};

}  // namespace shigusa::hdf5
