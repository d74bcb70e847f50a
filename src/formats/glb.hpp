// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// Little-endian 32-bit number at an offset within the bytes.
[[nodiscard]] inline std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return word;
}

inline void append_word(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> 8 * i & 0xFF);
}

inline constexpr std::size_t kGlbHeader = 12;      // bytes of the file's own
inline constexpr std::size_t kGlbChunkHeader = 8;  // and of each chunk's: length and kind
inline constexpr std::string_view kGlbJson = "JSON";
inline constexpr std::string_view kGlbBinary{"BIN\0", 4};

// Writes a GLB file of these chunks. The JSON text is padded to whole words; other chunks must
// consist of whole words.
[[nodiscard]] std::string glb_file(std::string json, std::optional<std::string_view> binary = {},
                                   std::string_view further = {});

// Parts of a file: chunks of a GLB, or the text of a .gltf.
struct GlbParts {
  std::string_view json;
  std::optional<std::string_view> binary;
  std::string_view further;  // chunks, whole
  bool glb = false;
};

// JSON text of a file: the first chunk of a GLB, else all of it. Checks the headers of a GLB and of
// its first chunk, for all readers. `name` stands for the file in errors.
[[nodiscard]] Result<std::string_view> gltf_text(std::string_view bytes, std::string_view name);

// Parts of any file, checked; the content of the JSON text is not.
[[nodiscard]] Result<GlbParts> glb_parts(std::string_view bytes, std::string_view name);

}  // namespace shigusa
