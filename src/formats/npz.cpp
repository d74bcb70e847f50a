// SPDX-License-Identifier: MIT
#include "formats/npz.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "core/bytes.hpp"
#include "core/check.hpp"
#include "core/text.hpp"

namespace shigusa {
namespace {

static_assert(std::endian::native == std::endian::little);

// Bytes of values, with their type as NumPy names it.
struct Numbers {
  std::string type;
  std::string bytes;
};

template <class Value>
constexpr const char* kType = "<f8";
template <>
constexpr const char* kType<float> = "<f4";
template <>
constexpr const char* kType<std::int32_t> = "<i4";
template <>
constexpr const char* kType<std::uint8_t> = "|b1";

template <class Value>
Numbers numbers_of(const std::vector<Value>& values) {
  return {kType<Value>,
          {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)}};
}

std::u32string characters(std::string_view text) {
  constexpr char32_t kUnknown = 0xFFFD;  // replaces invalid UTF-8
  std::u32string all;
  while (!text.empty()) {
    const std::size_t size = utf8_length(text);
    char32_t c = static_cast<unsigned char>(text[0]);
    if (size > 1) c &= 0xFFU >> (size + 1);
    for (std::size_t k = 1; k < size; ++k) {
      c = c << 6 | (static_cast<unsigned char>(text[k]) & 0x3F);
    }
    all += size == 0 ? kUnknown : c;
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return all;
}

Numbers numbers_of(const std::vector<std::string>& values) {
  std::vector<std::u32string> all;
  std::size_t longest = 1;
  for (const std::string& value : values) {
    all.push_back(characters(value));
    longest = std::max(longest, all.back().size());
  }
  Numbers numbers{fmt::format("<U{}", longest), {}};
  for (std::u32string& value : all) {
    value.resize(longest, U'\0');
    numbers.bytes.append(reinterpret_cast<const char*>(value.data()), 4 * longest);
  }
  return numbers;
}

// An array's own file, version 1.0: a header in Python's notation, padded so that numbers are
// aligned to 64 bytes, and the numbers.
std::string npy_file(const NpzArray& array) {
  const auto [type, bytes] =
      std::visit([](const auto& values) { return numbers_of(values); }, array.values);
  std::size_t count = 1;
  for (const std::size_t side : array.shape) count *= side;
  // of one side as a tuple of Python's
  const std::string shape =
      fmt::format("{}{}", fmt::join(array.shape, ","), array.shape.size() == 1 ? "," : "");
  SHG_CHECK(count == std::visit([](const auto& values) { return values.size(); }, array.values),
            "an array has the values of its shape");
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  constexpr std::size_t kBefore = 10;  // bytes
  header.append(63 - (kBefore + header.size()) % 64, ' ');
  header += '\n';
  std::string file("\x93NUMPY\x01\x00", 8);
  file += static_cast<char>(header.size() & 0xFF);
  file += static_cast<char>(header.size() >> 8);
  return file + header + bytes;
}

// CRC-32 of ISO 3309, the check sum of archives.
std::uint32_t crc32(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      table[n] = n;
      for (int bit = 0; bit < 8; ++bit) {
        table[n] = table[n] >> 1 ^ (0xEDB88320 & (0 - (table[n] & 1)));
      }
    }
    return table;
  }();
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : bytes) crc = kTable[(crc ^ static_cast<unsigned char>(c)) & 0xFF] ^ crc >> 8;
  return ~crc;
}

template <class... Values>
std::string little_endian(Values... values) {
  std::string bytes;
  (append_bytes(bytes, values), ...);
  return bytes;
}

using U16 = std::uint16_t;
using U32 = std::uint32_t;

// The part that both headers of a file in an archive have: version 2.0, a name in UTF-8, stored,
// the earliest date, check sum, sizes, and the length of the name.
std::string facts(std::string_view name, std::string_view file) {
  const auto size = static_cast<U32>(file.size());
  return little_endian(U16{20}, U16{1 << 11}, U16{0}, U16{0}, U16{1 << 5 | 1}, crc32(file), size,
                       size, static_cast<U16>(name.size()), U16{0});
}

}  // namespace

std::string format_npz(std::span<const NpzArray> arrays) {
  std::string archive;
  std::string directory;
  for (const NpzArray& array : arrays) {
    const std::string name = array.name + ".npy";
    const std::string file = npy_file(array);
    SHG_CHECK(archive.size() + file.size() < 0xF0000000, "an archive has less than 4 GiB");
    const std::string known = facts(name, file);
    directory += little_endian(U32{0x02014B50}, U16{20}) + known +
                 little_endian(U16{0}, U16{0}, U16{0}, U32{0}, static_cast<U32>(archive.size())) +
                 name;
    archive += little_endian(U32{0x04034B50}) + known + name + file;
  }
  const auto begin = static_cast<U32>(archive.size());
  const auto count = static_cast<U16>(arrays.size());
  return archive + directory +
         little_endian(U32{0x06054B50}, U16{0}, U16{0}, count, count,
                       static_cast<U32>(directory.size()), begin, U16{0});
}

}  // namespace shigusa
