// SPDX-License-Identifier: MIT
#include "glb.hpp"

#include <fmt/format.h>

namespace shigusa {

Result<GlbParts> glb_parts(std::string_view bytes, std::string_view name) {
  if (!bytes.starts_with("glTF")) return GlbParts{bytes, {}, {}, false};
  // the reader has seen to the header and the first chunk
  const std::size_t json_end = kGlbHeader + kGlbChunkHeader + word_at(bytes, kGlbHeader);
  if (word_at(bytes, 8) < json_end) {
    return fail(ErrorCode::parse,
                fmt::format("its header tells {} bytes, but its first chunk ends after {}",
                            word_at(bytes, 8), json_end),
                std::string(name));
  }
  GlbParts parts{
      bytes.substr(kGlbHeader + kGlbChunkHeader, word_at(bytes, kGlbHeader)), {}, {}, true};
  std::string_view rest = bytes.substr(json_end, word_at(bytes, 8) - json_end);
  if (rest.size() >= kGlbChunkHeader && rest.substr(4, 4) == kGlbBinary) {
    const std::size_t length = word_at(rest, 0);
    if (length > rest.size() - kGlbChunkHeader) {
      return fail(ErrorCode::parse,
                  fmt::format("its binary chunk tells {} bytes, but {} follow", length,
                              rest.size() - kGlbChunkHeader),
                  std::string(name));
    }
    parts.binary = rest.substr(kGlbChunkHeader, length);
    rest = rest.substr(kGlbChunkHeader + length);
  }
  parts.further = rest;
  return parts;
}

}  // namespace shigusa
