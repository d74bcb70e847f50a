// SPDX-License-Identifier: MIT
#include "glb.hpp"

#include <fmt/format.h>

#include "core/say.hpp"

namespace shigusa {

std::string glb_file(std::string json, std::optional<std::string_view> binary,
                     std::string_view further) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string chunks;
  const auto add = [&](std::string_view kind, std::string_view bytes) {
    append_word(chunks, static_cast<std::uint32_t>(bytes.size()));
    (chunks += kind) += bytes;
  };
  add(kGlbJson, json);
  if (binary) add(kGlbBinary, *binary);
  chunks += further;
  std::string file = "glTF";
  append_word(file, 2);
  append_word(file, static_cast<std::uint32_t>(chunks.size() + kGlbHeader));
  return file += chunks;
}

Result<std::string_view> gltf_text(std::string_view bytes, std::string_view name) {
  constexpr std::uint32_t kVersion = 2;
  constexpr std::size_t kHeader = kGlbHeader + kGlbChunkHeader;
  if (!bytes.starts_with("glTF")) return bytes;
  const std::string place(name);
  if (bytes.size() < kHeader) {
    return fail(ErrorCode::parse, say("glb_short", bytes.size(), kHeader), place);
  }
  if (word_at(bytes, 4) != kVersion) {
    return fail(ErrorCode::unsupported, say("glb_version", word_at(bytes, 4), kVersion), place);
  }
  const std::size_t size = word_at(bytes, 8);
  if (size > bytes.size()) {
    return fail(ErrorCode::parse, say("glb_cut", size, bytes.size()), place);
  }
  const std::size_t length = word_at(bytes, kGlbHeader);
  if (bytes.substr(kGlbHeader + 4, 4) != kGlbJson || length > bytes.size() - kHeader) {
    return fail(ErrorCode::parse, say("glb_first_chunk", bytes.size() - kHeader, length), place);
  }
  if (size < kHeader + length) {
    return fail(ErrorCode::parse, say("glb_chunk_ends", size, kHeader + length), place);
  }
  // some writers fill the chunk up with zeros in place of blanks
  std::string_view json = bytes.substr(kHeader, length);
  while (json.ends_with('\0')) json.remove_suffix(1);
  return json;
}

Result<GlbParts> glb_parts(std::string_view bytes, std::string_view name) {
  if (!bytes.starts_with("glTF")) return GlbParts{bytes, {}, {}, false};
  SHG_TRY_ASSIGN(const std::string_view json, gltf_text(bytes, name));
  const std::size_t json_end = kGlbHeader + kGlbChunkHeader + word_at(bytes, kGlbHeader);
  GlbParts parts{json, {}, {}, true};
  std::string_view rest = bytes.substr(json_end, word_at(bytes, 8) - json_end);
  if (rest.size() >= kGlbChunkHeader && rest.substr(4, 4) == kGlbBinary) {
    const std::size_t length = word_at(rest, 0);
    if (length > rest.size() - kGlbChunkHeader) {
      return fail(ErrorCode::parse, say("glb_binary_chunk", length, rest.size() - kGlbChunkHeader),
                  std::string(name));
    }
    parts.binary = rest.substr(kGlbChunkHeader, length);
    rest = rest.substr(kGlbChunkHeader + length);
  }
  parts.further = rest;
  return parts;
}

}  // namespace shigusa
