// SPDX-License-Identifier: MIT
#include "files/file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "staging.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

// Whether a path is a named pipe, which may have no process at its other end. The program's own
// streams, /dev/stdin and a shell's /dev/fd/63, have one.
bool waits_for_another(const fs::path& path, mode_t mode) {
  const std::string name = path.string();
  return S_ISFIFO(mode) && !name.starts_with("/dev/") && !name.starts_with("/proc/");
}

tl::unexpected<Error> refused_pipe(const fs::path& path) {
  return fail(ErrorCode::io, "is a pipe; a file is expected", path.string());
}

// Writes to a device, or to a pipe with a reader.
Result<void> write_through(const fs::path& path, std::string_view bytes) {
  Descriptor file = open_at(AT_FDCWD, path.c_str(), O_WRONLY);
  if (!file) return refused(path, "write", errno);
  int reason = write_all(file, bytes);
  if (reason == 0) reason = file.close();
  return reason == 0 ? Result<void>{} : refused(path, "write", reason);
}

}  // namespace

Result<std::string> read_text_file(const fs::path& path, std::size_t max_bytes) {
  const Descriptor file = open_to_read(path);
  struct stat status {};
  if (!file || fstat(file.number(), &status) != 0) return refused(path, "open", errno);
  if (waits_for_another(path, status.st_mode)) return refused_pipe(path);
  // reads of the permitted kinds may wait
  if (fcntl(file.number(), F_SETFL, 0) != 0) return refused(path, "open", errno);
  std::string bytes;
  char block[1 << 16];
  for (;;) {
    const ssize_t count = read_some(file, block, sizeof block);
    if (count < 0) return refused(path, "read", errno);
    if (count == 0) return bytes;
    if (static_cast<std::size_t>(count) > max_bytes - bytes.size()) {
      return fail(ErrorCode::io, fmt::format("holds more than the {} bytes allowed", max_bytes),
                  path.string());
    }
    bytes.append(block, static_cast<std::size_t>(count));
  }
}

Result<void> write_file(const fs::path& path, std::string_view bytes) {
  struct stat old {};
  const bool exists = stat(path.c_str(), &old) == 0;
  if (exists && waits_for_another(path, old.st_mode)) return refused_pipe(path);
  if (exists && S_ISDIR(old.st_mode)) return refused(path, "write", EISDIR);
  if (exists && !S_ISREG(old.st_mode)) return write_through(path, bytes);
  // a rename alone would also replace files that the user has no right to change
  if (exists && access(path.c_str(), W_OK) != 0) return refused(path, "write", errno);

  std::error_code error;
  const fs::path target = exists ? fs::canonical(path, error) : path;
  const fs::path above = target.has_parent_path() ? target.parent_path() : ".";
  const std::string name = target.filename().string();
  Staging staging;
  int reason = staging.open(above);
  if (reason == 0) reason = staging.make();
  if (reason == 0) reason = staging.add(name, bytes, false);
  if (reason == 0) reason = staging.move_out(name, name);
  return reason == 0 ? Result<void>{} : refused(path, "write", reason);
}

}  // namespace shigusa
