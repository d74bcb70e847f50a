// SPDX-License-Identifier: MIT
#include "descriptor.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace shigusa {

int Descriptor::close() {
  if (number_ < 0) return 0;
  return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno;
}

Descriptor open_at(int folder, const char* name, int flags, mode_t mode) {
  const int number = openat(folder, name, flags | O_CLOEXEC | O_NOCTTY, mode);
  if (number < 0 || number > STDERR_FILENO) return Descriptor(number);
  const int higher = fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int reason = errno;
  ::close(number);
  errno = reason;
  return Descriptor(higher);
}

int write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file.number(), bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

ssize_t read_some(const Descriptor& file, char* block, std::size_t size) {
  for (;;) {
    const ssize_t count = read(file.number(), block, size);
    if (count >= 0 || errno != EINTR) return count;
  }
}

tl::unexpected<Error> refused(const std::filesystem::path& path, const char* action, int reason) {
  const auto code = reason == ENOENT ? ErrorCode::not_found : ErrorCode::io;
  const std::string why = std::generic_category().message(reason == 0 ? EIO : reason);
  return fail(code, fmt::format("cannot {}: {}", action, why), path.string());
}

}  // namespace shigusa
