// SPDX-License-Identifier: MIT
#include <sha2.h>

#include <cstdint>

#include "sha256.hpp"

namespace shigusa {
namespace {

void add(SHA2_CTX& context, const char* bytes, std::size_t size) {
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes), size);
}

std::string digits(SHA2_CTX& context) {
  char text[SHA256_DIGEST_STRING_LENGTH];
  return SHA256End(&context, text);
}

}  // namespace

std::string sha256(std::string_view bytes) {
  SHA2_CTX context;
  SHA256Init(&context);
  add(context, bytes.data(), bytes.size());
  return digits(context);
}

std::string sha256_of(const Descriptor& file) {
  SHA2_CTX context;
  SHA256Init(&context);
  char block[1 << 16];
  for (;;) {
    const std::ptrdiff_t count = read_some(file, block, sizeof block);
    if (count < 0) return {};
    if (count == 0) return digits(context);
    add(context, block, static_cast<std::size_t>(count));
  }
}

}  // namespace shigusa
