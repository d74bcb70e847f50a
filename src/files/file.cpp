// SPDX-License-Identifier: MIT
#include "files/file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <system_error>

#include "staging.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

// Whether a path is a named pipe, which may have no process at its other end. The program's own
// streams, /dev/stdin and a shell's /dev/fd/63, have one.
bool waits_for_another(const fs::path& path, fs::file_type type) {
  const std::string name = path.string();
  return type == fs::file_type::fifo && !name.starts_with("/dev/") && !name.starts_with("/proc/");
}

tl::unexpected<Error> refused_pipe(const fs::path& path) {
  return fail(ErrorCode::io, "is a pipe; a file is expected", path.string());
}

// Writes to a device, or to a pipe with a reader.
Result<void> write_through(const fs::path& path, std::string_view bytes) {
  Descriptor file = open_to_write(path);
  if (!file) return refused(path, "write", errno);
  int reason = write_all(file, bytes);
  if (reason == 0) reason = file.close();
  return reason == 0 ? Result<void>{} : refused(path, "write", reason);
}

}  // namespace

Result<std::string> read_text_file(const fs::path& path, std::size_t max_bytes) {
  const Descriptor file = open_to_read(path);
  if (!file) return refused(path, "open", errno);
  if (waits_for_another(path, type_of(file))) return refused_pipe(path);
  // reads of the permitted kinds may wait
  if (const int reason = let_wait(file)) return refused(path, "open", reason);
  std::string bytes;
  char block[1 << 16];
  for (;;) {
    const std::ptrdiff_t count = read_some(file, block, sizeof block);
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
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  const bool exists = fs::exists(fs::file_status(type));
  if (exists && waits_for_another(path, type)) return refused_pipe(path);
  if (type == fs::file_type::directory) return refused(path, "write", EISDIR);
  if (exists && type != fs::file_type::regular) return write_through(path, bytes);
  const fs::path target = exists ? fs::canonical(path, error) : path;
  const fs::path above = target.has_parent_path() ? target.parent_path() : ".";
  const std::string name = target.filename().string();
  Staging staging;
  int reason = staging.open(above);
  // a rename alone would also replace files that the user has no right to change
  if (reason == 0 && exists) reason = check_writable(staging.folder(), name);
  if (reason == 0) reason = staging.make();
  if (reason == 0) reason = staging.add(name, bytes, false);
  if (reason == 0) reason = staging.move_out(name, name);
  return reason == 0 ? Result<void>{} : refused(path, "write", reason);
}

}  // namespace shigusa
