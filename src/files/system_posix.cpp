// SPDX-License-Identifier: MIT
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <memory>

#include "folder.hpp"
#include "pages.hpp"
#include "path.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

int number_of(const Descriptor& entry) { return static_cast<int>(entry.number()); }

int told(int result) { return result == 0 ? 0 : errno; }

// openat() of a name in a folder (AT_FDCWD: the working directory), with close-on-exec.
Descriptor open_at(int folder, const char* name, int flags) {
  const int number = openat(folder, name, flags | O_CLOEXEC | O_NOCTTY, 0666);
  if (number < 0 || number > STDERR_FILENO) return Descriptor(number);
  const int higher = fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int reason = errno;
  ::close(number);
  errno = reason;
  return Descriptor(higher);
}

struct FolderCloser {
  void operator()(DIR* folder) const { closedir(folder); }
};

fs::file_type type_of_mode(mode_t mode) {
  if (S_ISREG(mode)) return fs::file_type::regular;
  if (S_ISDIR(mode)) return fs::file_type::directory;
  if (S_ISLNK(mode)) return fs::file_type::symlink;
  return S_ISFIFO(mode) ? fs::file_type::fifo : fs::file_type::unknown;
}

// The status of an open file, or of a name in a folder, where a link is itself.
std::optional<struct stat> status_of(const Descriptor& entry) {
  struct stat status {};
  if (fstat(number_of(entry), &status) != 0) return std::nullopt;
  return status;
}
std::optional<struct stat> status_in(const Descriptor& folder, const std::string& name) {
  struct stat status {};
  if (fstatat(number_of(folder), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
    return std::nullopt;
  }
  return status;
}

fs::file_type type_told(const std::optional<struct stat>& status) {
  return status ? type_of_mode(status->st_mode) : fs::file_type::not_found;
}

}  // namespace

int Descriptor::close() {
  if (number_ == -1) return 0;
  return told(::close(static_cast<int>(std::exchange(number_, -1))));
}

Descriptor open_to_read(const fs::path& path) {
  return open_at(AT_FDCWD, path.c_str(), O_RDONLY | O_NONBLOCK);
}

int let_wait(const Descriptor& file) { return told(fcntl(number_of(file), F_SETFL, 0)); }

Descriptor open_to_write(const fs::path& path) { return open_at(AT_FDCWD, path.c_str(), O_WRONLY); }

int write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(number_of(file), bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

std::ptrdiff_t read_some(const Descriptor& file, char* block, std::size_t size) {
  for (;;) {
    const ssize_t count = read(number_of(file), block, size);
    if (count >= 0 || errno != EINTR) return count;
  }
}

bool read_at(const Descriptor& file, std::uint64_t at, char* block, std::size_t size) {
  while (size > 0) {
    const ssize_t count = pread(number_of(file), block, size, static_cast<off_t>(at));
    if (count <= 0) return false;
    block += count;
    at += static_cast<std::uint64_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

int go_to(const Descriptor& file, std::uint64_t at) {
  return lseek(number_of(file), static_cast<off_t>(at), SEEK_SET) < 0 ? errno : 0;
}

std::optional<std::uint64_t> go_to_end(const Descriptor& file) {
  const off_t end = lseek(number_of(file), 0, SEEK_END);
  if (end < 0) return std::nullopt;
  return static_cast<std::uint64_t>(end);
}

Descriptor open_folder(const fs::path& path) {
  return open_at(AT_FDCWD, path.c_str(), O_RDONLY | O_DIRECTORY);
}

Descriptor open_entry(const Descriptor& folder, const std::string& name) {
  return open_at(number_of(folder), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
}

Descriptor create_in(const Descriptor& folder, const std::string& name) {
  return open_at(number_of(folder), name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW);
}

std::vector<std::string> names_in(const Descriptor& folder) {
  std::vector<std::string> names;
  Descriptor again = open_at(number_of(folder), ".", O_RDONLY | O_DIRECTORY);
  if (!again) return names;
  const std::unique_ptr<DIR, FolderCloser> entries(fdopendir(number_of(again)));
  if (!entries) return names;
  // closed with the entries
  (void)again.release();
  while (const dirent* entry = readdir(entries.get())) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  return names;
}

fs::file_type type_of(const Descriptor& entry) { return type_told(status_of(entry)); }

fs::file_type type_in(const Descriptor& folder, const std::string& name) {
  return type_told(status_in(folder, name));
}

bool is_named(const Descriptor& entry, const Descriptor& folder, const std::string& name) {
  const auto ours = status_of(entry);
  const auto named = status_in(folder, name);
  return ours && named && ours->st_ino == named->st_ino;
}

bool older_than(const Descriptor& entry, std::chrono::seconds age) {
  const auto status = status_of(entry);
  return status && status->st_mtime + age.count() < std::time(nullptr);
}

int check_writable(const Descriptor& folder, const std::string& name) {
  return told(faccessat(number_of(folder), name.c_str(), W_OK, 0));
}

int make_folder_in(const Descriptor& folder, const std::string& name) {
  return told(mkdirat(number_of(folder), name.c_str(), 0700));
}

int remove_in(const Descriptor& folder, const std::string& name) {
  return told(unlinkat(number_of(folder), name.c_str(), 0));
}

int remove_folder_in(const Descriptor& folder, const std::string& name) {
  return told(unlinkat(number_of(folder), name.c_str(), AT_REMOVEDIR));
}

int move_in(const Descriptor& from, const std::string& name, const Descriptor& folder,
            const std::string& to) {
  constexpr mode_t kPermissions = 0777;
  const auto old = status_in(folder, to);
  if (old && S_ISREG(old->st_mode) &&
      fchmodat(number_of(from), name.c_str(), old->st_mode & kPermissions, 0) != 0) {
    return errno;
  }
  return told(renameat(number_of(from), name.c_str(), number_of(folder), to.c_str()));
}

int settle(const Descriptor& entry) {
  return fsync(number_of(entry)) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

int lock_now(const Descriptor& entry, LockKind kind) {
  const int how = kind == LockKind::alone ? LOCK_EX : LOCK_SH;
  return told(flock(number_of(entry), how | LOCK_NB));
}

std::optional<fs::path> path_in_environment(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

fs::path to_path(std::string_view text) { return text; }

void* take_pages(std::size_t bytes) {
  void* const pages =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return pages == MAP_FAILED ? nullptr : pages;
}

void give_pages(void* pages, std::size_t bytes) noexcept { munmap(pages, bytes); }

}  // namespace shigusa
