// SPDX-License-Identifier: MIT
#include "door.hpp"

#include <cstring>
#include <string_view>

namespace shigusa::door {
namespace {

// The message has room of its own, so that it is there even where memory is not to be had.
constexpr std::size_t kMessageBytes = 1024;
thread_local char last_message[kMessageBytes] = "";
thread_local Error last_error;  // of what has no Error the text alone is told

shigusa_status status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
      return SHIGUSA_INVALID_ARGUMENT;
    case ErrorCode::not_found:
      return SHIGUSA_NOT_FOUND;
    case ErrorCode::parse:
      return SHIGUSA_PARSE;
    case ErrorCode::io:
      return SHIGUSA_IO;
    case ErrorCode::unsupported:
      return SHIGUSA_UNSUPPORTED;
    case ErrorCode::cancelled:
      return SHIGUSA_CANCELLED;
  }
  return SHIGUSA_FAULT;
}

// As many bytes of UTF-8 text as fit, without half a character.
std::size_t fitting(std::string_view text) {
  std::size_t size = std::min(text.size(), kMessageBytes - 1);
  const auto continues = [&](std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  while (size > 0 && continues(size)) --size;
  return size;
}

void keep(std::string_view message) {
  const std::size_t size = fitting(message);
  std::memcpy(last_message, message.data(), size);
  last_message[size] = '\0';
}

}  // namespace

shigusa_status refuse(shigusa_status status, const char* message) {
  keep(message);
  last_error = {};
  return status;
}

shigusa_status refuse(Error error) {
  keep(error.to_string());
  last_error = std::move(error);
  return status_of(last_error.code);
}

Result<void> give(std::string text, shigusa_bytes** bytes) {
  *bytes = new shigusa_bytes{std::move(text)};
  return {};
}

}  // namespace shigusa::door

extern "C" {

uint32_t shigusa_abi_version(void) { return SHIGUSA_ABI_VERSION; }

const char* shigusa_version(void) { return SHIGUSA_VERSION; }

const char* shigusa_message(void) { return shigusa::door::last_message; }

shigusa_status shigusa_failure(shigusa_bytes** json) {
  if (json == nullptr) return SHIGUSA_INVALID_ARGUMENT;
  try {
    using namespace shigusa;
    const Error& last = door::last_error;
    const Error text{ErrorCode::invalid_argument, std::string_view(door::last_message), {}};
    *json = new shigusa_bytes{format_failure(last.message.empty() ? text : last)};
    return SHIGUSA_OK;
  } catch (...) {
    return SHIGUSA_OUT_OF_MEMORY;
  }
}

const char* shigusa_bytes_data(const shigusa_bytes* bytes) {
  return bytes == nullptr ? "" : bytes->text.c_str();
}

size_t shigusa_bytes_size(const shigusa_bytes* bytes) {
  return bytes == nullptr ? 0 : bytes->text.size();
}

shigusa_status shigusa_facts(shigusa_bytes** json) {
  return shigusa::door::guarded([&]() -> shigusa::Result<void> {
    SHG_TRY(shigusa::door::need("json", json));
    return shigusa::door::give(shigusa::format_facts(), json);
  });
}

void shigusa_bytes_free(shigusa_bytes* bytes) { delete bytes; }

}  // extern "C"
