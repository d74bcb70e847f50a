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

Descriptor open_at(int folder, const char* name, int flags) {
  const int number = openat(folder, name, flags | O_CLOEXEC | O_NOCTTY, 0666);
  if (number < 0 || number > STDERR_FILENO) return Descriptor(number);
  const int higher = fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int reason = errno;
  ::close(number);
  errno = reason;
  return Descriptor(higher);
}

Descriptor open_to_read(const std::filesystem::path& path) {
  return open_at(AT_FDCWD, path.c_str(), O_RDONLY | O_NONBLOCK);
}

int write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file.number(), bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

std::ptrdiff_t read_some(const Descriptor& file, char* block, std::size_t size) {
  for (;;) {
    const ssize_t count = read(file.number(), block, size);
    if (count >= 0 || errno != EINTR) return count;
  }
}

bool read_at(const Descriptor& file, std::uint64_t at, char* block, std::size_t size) {
  while (size > 0) {
    const ssize_t count = pread(file.number(), block, size, static_cast<off_t>(at));
    if (count <= 0) return false;
    block += count;
    at += static_cast<std::uint64_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

int go_to(const Descriptor& file, std::uint64_t at) {
  return lseek(file.number(), static_cast<off_t>(at), SEEK_SET) < 0 ? errno : 0;
}

std::optional<std::uint64_t> go_to_end(const Descriptor& file) {
  const off_t end = lseek(file.number(), 0, SEEK_END);
  if (end < 0) return std::nullopt;
  return static_cast<std::uint64_t>(end);
}

tl::unexpected<Error> refused(const std::filesystem::path& path, const char* action, int reason) {
  const auto code = reason == ENOENT ? ErrorCode::not_found : ErrorCode::io;
  const std::string why = std::generic_category().message(reason == 0 ? EIO : reason);
  return fail(code, fmt::format("cannot {}: {}", action, why), path.string());
}

}  // namespace shigusa
