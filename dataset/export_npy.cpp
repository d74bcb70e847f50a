// SPDX-License-Identifier: MIT
#include "export_npy.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <bit>
#include <memory>

namespace shigusa::npy {
namespace {

constexpr std::size_t kAlignment = 64;  // of the numbers
constexpr char32_t kUnknown = 0xFFFD;   // replaces invalid UTF-8

std::string shape_text(const Shape& shape) {
  std::string text = "(";
  for (const std::size_t side : shape) text += fmt::format("{},", side);
  if (shape.size() > 1) text.pop_back();
  return text + ")";
}

// Bytes of an array's file; `type`: "<f4".
std::string file_of(std::string_view type, const Shape& shape, std::string_view numbers) {
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type,
                                   shape_text(shape));
  constexpr std::size_t kBefore = 10;  // bytes
  const std::size_t size = kBefore + header.size() + 1;
  header.append((kAlignment - size % kAlignment) % kAlignment, ' ');
  header += '\n';
  std::string file("\x93NUMPY\x01\x00", 8);
  file += static_cast<char>(header.size() & 0xFF);
  file += static_cast<char>(header.size() >> 8);
  file += header;
  file += numbers;
  return file;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// Code points of a UTF-8 text.
std::u32string characters(std::string_view text) {
  std::u32string all;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t size = byte < 0x80 ? 1 : byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
    char32_t c = size == 1 ? byte : byte & (0xFFU >> (size + 1));
    for (std::size_t k = 1; k < size; ++k) {
      const bool there = at + k < text.size() && (text[at + k] & 0xC0) == 0x80;
      c = there && c != kUnknown ? (c << 6 | (static_cast<unsigned char>(text[at + k]) & 0x3F))
                                 : kUnknown;
    }
    all += c;
    at += size;
  }
  return all;
}

std::string text_file(const std::vector<std::string>& values, const Shape& shape) {
  std::vector<std::u32string> all;
  std::size_t longest = 1;
  for (const std::string& value : values) {
    all.push_back(characters(value));
    longest = std::max(longest, all.back().size());
  }
  std::string bytes;
  for (std::u32string& value : all) {
    value.resize(longest, U'\0');
    bytes.append(reinterpret_cast<const char*>(value.data()), 4 * value.size());
  }
  return file_of(fmt::format("<U{}", longest), shape, bytes);
}

struct SourceFree {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, SourceFree>;

tl::unexpected<Error> failed(const char* why) {
  return fail(ErrorCode::io, fmt::format("cannot make an archive: libzip says: {}", why), "npz");
}

// Adds an array's file to an open archive.
bool add(zip_t* archive, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  if (source == nullptr) return false;
  const zip_int64_t place =
      zip_file_add(archive, (name + ".npy").c_str(), source, ZIP_FL_ENC_GUESS);
  if (place < 0) {
    zip_source_free(source);
    return false;
  }
  const auto at = static_cast<zip_uint64_t>(place);
  // the earliest date of an archive: the current time would change the bytes
  constexpr zip_uint16_t kFirstDay = 1 << 5 | 1;
  return zip_set_file_compression(archive, at, ZIP_CM_STORE, 0) == 0 &&
         zip_file_set_dostime(archive, at, 0, kFirstDay, 0) == 0;
}

Result<std::string> bytes_in(zip_source_t* source) {
  zip_stat_t facts;
  if (zip_source_stat(source, &facts) < 0 || zip_source_open(source) < 0) {
    return failed(zip_error_strerror(zip_source_error(source)));
  }
  std::string bytes(facts.size, '\0');
  const zip_int64_t size = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (size != static_cast<zip_int64_t>(bytes.size())) return failed("it ends too early");
  return bytes;
}

}  // namespace

std::string floats(const std::vector<float>& values, const Shape& shape) {
  return file_of("<f4", shape, bytes_of(values));
}
std::string doubles(const std::vector<double>& values, const Shape& shape) {
  return file_of("<f8", shape, bytes_of(values));
}
std::string integers(const std::vector<std::int32_t>& values, const Shape& shape) {
  return file_of("<i4", shape, bytes_of(values));
}
std::string texts(const std::vector<std::string>& values) {
  return text_file(values, {values.size()});
}
std::string text(std::string_view value) { return text_file({std::string(value)}, {}); }

Result<std::string> archive(const Arrays& arrays) {
  zip_error_t error;
  zip_error_init(&error);
  const Source memory(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!memory) return failed(zip_error_strerror(&error));
  // the archive releases one of the source's two references
  zip_source_keep(memory.get());
  zip_t* open = zip_open_from_source(memory.get(), ZIP_TRUNCATE, &error);
  if (open == nullptr) {
    zip_source_free(memory.get());
    return failed(zip_error_strerror(&error));
  }
  for (const auto& [name, bytes] : arrays) {
    if (add(open, name, bytes)) continue;
    const std::string why = zip_strerror(open);
    zip_discard(open);
    return failed(why.c_str());
  }
  if (zip_close(open) < 0) {
    const std::string why = zip_strerror(open);
    zip_discard(open);
    return failed(why.c_str());
  }
  return bytes_in(memory.get());
}

}  // namespace shigusa::npy
