// SPDX-License-Identifier: MIT
#include "door.hpp"

#include <array>
#include <charconv>
#include <exception>
#include <new>
#include <optional>
#include <shigusa/shigusa.hpp>
#include <string_view>
#include <system_error>

#include "document/facts.hpp"
#include "failure.hpp"
#include "watch.hpp"

namespace shigusa::door {
namespace {

// Message for an exception of a host's own function.
shigusa_status refuse_host(const HostFault& host) noexcept {
  try {
    if (host.thrown) std::rethrow_exception(host.thrown);
  } catch (const std::exception& error) {
    return refuse(SHIGUSA_HOST, error.what());
  } catch (...) {
    // an exception without a message
  }
  return refuse(SHIGUSA_HOST, "the caller's own function threw what is no std::exception");
}

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

// The three numbers of a version, "0.2.0".
std::optional<std::array<int, 3>> version_numbers(std::string_view text) {
  std::array<int, 3> numbers{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), numbers[k]);
    if (error != std::errc{} || numbers[k] < 0) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (k == 2) break;
    if (!text.starts_with('.')) return std::nullopt;
    text.remove_prefix(1);
  }
  return text.empty() ? std::optional(numbers) : std::nullopt;
}

}  // namespace

shigusa_status refuse(shigusa_status status, const char* message) noexcept {
  keep_failure(message);
  return status;
}

shigusa_status refuse(Error error) {
  const shigusa_status status = status_of(error.code);
  keep_failure(std::move(error));
  return status;
}

shigusa_status refuse_exception() noexcept {
  constexpr const char* kNoMemory = "out of memory";
  try {
    throw;
  } catch (const HostFault& host) {
    return refuse_host(host);
  } catch (const std::bad_alloc&) {
    return refuse(SHIGUSA_OUT_OF_MEMORY, kNoMemory);
  } catch (const std::system_error& error) {
    // the system has no resources for more threads
    const bool full = error.code() == std::errc::resource_unavailable_try_again ||
                      error.code() == std::errc::not_enough_memory;
    return refuse(full ? SHIGUSA_OUT_OF_MEMORY : SHIGUSA_FAULT, full ? kNoMemory : error.what());
  } catch (const std::exception& error) {
    return refuse(SHIGUSA_FAULT, error.what());
  } catch (...) {
    return refuse(SHIGUSA_FAULT, "an unknown fault");
  }
}

Result<void> give(std::string text, shigusa_bytes** bytes) {
  *bytes = new shigusa_bytes{std::move(text)};
  return {};
}

}  // namespace shigusa::door

extern "C" {

uint32_t shigusa_abi_version(void) { return SHIGUSA_ABI_VERSION; }

const char* shigusa_version(void) { return SHIGUSA_VERSION; }

shigusa_status shigusa_check_version(uint32_t abi_version, const char* header_version) {
  using namespace shigusa;
  return door::guarded([&]() -> Result<void> {
    SHG_TRY(door::need("header_version", header_version));
    const auto header = door::version_numbers(header_version);
    if (!header) {
      return fail(ErrorCode::invalid_argument,
                  "header_version is no version such as " SHIGUSA_VERSION);
    }
    const std::array<int, 3> own{SHIGUSA_VERSION_MAJOR, SHIGUSA_VERSION_MINOR,
                                 SHIGUSA_VERSION_PATCH};
    if (abi_version == SHIGUSA_ABI_VERSION && own >= *header) return {};
    return fail(ErrorCode::unsupported, "the program was made for shigusa " +
                                            std::string(header_version) + " with ABI " +
                                            std::to_string(abi_version) +
                                            ", and the library is " SHIGUSA_VERSION " with ABI " +
                                            std::to_string(SHIGUSA_ABI_VERSION));
  });
}

const char* shigusa_message(void) { return shigusa::door::failure_text(); }

shigusa_status shigusa_failure(shigusa_bytes** json) {
  using namespace shigusa;
  if (json == nullptr) return SHIGUSA_INVALID_ARGUMENT;
  const door::OwnArithmetic arithmetic;
  try {
    const Error* const last = door::failure_error();
    const Error text{ErrorCode::invalid_argument, std::string_view(door::failure_text()), {}};
    *json = new shigusa_bytes{format_failure(last == nullptr ? text : *last)};
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
