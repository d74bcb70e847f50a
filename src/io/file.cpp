// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <shigusa/io/file.hpp>
#include <system_error>

namespace shigusa {
namespace {

namespace fs = std::filesystem;

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

File open(const fs::path& path, const char* mode) {
  errno = 0;
  return File(std::fopen(path.string().c_str(), mode));
}

// The C library's streams keep the system's reason in errno, where C++ streams lose it.
tl::unexpected<Error> refused(const fs::path& path, const char* action, int reason) {
  const auto code = reason == ENOENT ? ErrorCode::not_found : ErrorCode::io;
  const std::string why = std::generic_category().message(reason == 0 ? EIO : reason);
  return fail(code, fmt::format("cannot {}: {}", action, why), path.string());
}

// Writes and closes; 0, or the system's reason. A full disk may show only when the file is closed.
int write_and_close(File file, std::string_view bytes) {
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                       std::fflush(file.get()) == 0;
  const int reason = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (written && closed) return 0;
  const int last = written ? errno : reason;
  return last == 0 ? EIO : last;
}

// A new file in `folder`, under a name that nobody uses; `name` receives it.
File create_temporary(const fs::path& folder, fs::path& name) {
  constexpr int kNames = 1000;
  File file;
  for (int i = 0; i < kNames && !file; ++i) {
    name = folder / fmt::format(".shigusa-{}.tmp", i);
    file = open(name, "wbx");
    if (!file && errno != EEXIST) break;
  }
  return file;
}

}  // namespace

Result<std::string> read_text_file(const fs::path& path, std::size_t max_bytes) {
  const File file = open(path, "rb");
  if (!file) return refused(path, "open", errno);
  std::string bytes;
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    if (count > max_bytes - bytes.size()) {
      return fail(ErrorCode::io, fmt::format("holds more than the {} bytes allowed", max_bytes),
                  path.string());
    }
    bytes.append(block, count);
  }
  if (std::ferror(file.get()) != 0) return refused(path, "read", errno);
  return bytes;
}

Result<void> write_file(const fs::path& path, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status old = fs::status(path, ignored);
  const bool in_place = fs::exists(old) && !fs::is_regular_file(old);
  // renaming alone would also replace files that the user may not change
  if (fs::is_regular_file(old) && !open(path, "r+b")) return refused(path, "write", errno);

  const fs::path target = fs::is_regular_file(old) ? fs::canonical(path, ignored) : path;
  fs::path written = target;
  File file = in_place ? open(target, "wb") : create_temporary(target.parent_path(), written);
  if (!file) return refused(path, "write", errno);
  int reason = write_and_close(std::move(file), bytes);
  if (!in_place && reason == 0) {
    if (fs::is_regular_file(old)) fs::permissions(written, old.permissions(), ignored);
    std::error_code renamed;
    fs::rename(written, target, renamed);
    reason = renamed.value();
  }
  if (reason == 0) return {};
  if (!in_place) fs::remove(written, ignored);
  return refused(path, "write", reason);
}

}  // namespace shigusa
