// SPDX-License-Identifier: MIT
#include "descriptor.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <system_error>

namespace shigusa {

tl::unexpected<Error> refused(const std::filesystem::path& path, const char* action, int reason) {
  const auto code = reason == ENOENT ? ErrorCode::not_found : ErrorCode::io;
  const std::string why = reason == EBUSY
                              ? "another program uses it"
                              : std::generic_category().message(reason == 0 ? EIO : reason);
  return fail(code, fmt::format("cannot {}: {}", action, why), path.string());
}

}  // namespace shigusa
