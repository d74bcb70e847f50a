// SPDX-License-Identifier: MIT
#include "folder.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>

namespace shigusa {
namespace {

namespace fs = std::filesystem;

struct FolderCloser {
  void operator()(DIR* folder) const { closedir(folder); }
};

fs::file_type type_of_mode(mode_t mode) {
  if (S_ISREG(mode)) return fs::file_type::regular;
  if (S_ISDIR(mode)) return fs::file_type::directory;
  if (S_ISLNK(mode)) return fs::file_type::symlink;
  return S_ISFIFO(mode) ? fs::file_type::fifo : fs::file_type::unknown;
}

}  // namespace

Descriptor open_folder(const fs::path& path) {
  return open_at(AT_FDCWD, path.c_str(), O_RDONLY | O_DIRECTORY);
}

Descriptor open_entry(const Descriptor& folder, const std::string& name) {
  return open_at(folder.number(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
}

std::vector<std::string> names_in(const Descriptor& folder) {
  std::vector<std::string> names;
  Descriptor again = open_at(folder.number(), ".", O_RDONLY | O_DIRECTORY);
  if (!again) return names;
  const std::unique_ptr<DIR, FolderCloser> entries(fdopendir(again.number()));
  if (!entries) return names;
  // closed with the entries
  (void)again.release();
  while (const dirent* entry = readdir(entries.get())) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  return names;
}

fs::file_type type_of(const Descriptor& entry) {
  struct stat status {};
  const bool told = fstat(entry.number(), &status) == 0;
  return told ? type_of_mode(status.st_mode) : fs::file_type::not_found;
}

fs::file_type type_in(const Descriptor& folder, const std::string& name) {
  struct stat status {};
  const bool told = fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
  return told ? type_of_mode(status.st_mode) : fs::file_type::not_found;
}

int check_writable(const Descriptor& folder, const std::string& name) {
  return faccessat(folder.number(), name.c_str(), W_OK, 0) == 0 ? 0 : errno;
}

int remove_in(const Descriptor& folder, const std::string& name) {
  return unlinkat(folder.number(), name.c_str(), 0) == 0 ? 0 : errno;
}

int settle(const Descriptor& entry) {
  return fsync(entry.number()) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

bool try_lock(const Descriptor& entry, LockKind kind) {
  const int how = kind == LockKind::alone ? LOCK_EX : LOCK_SH;
  return flock(entry.number(), how | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR);
}

}  // namespace shigusa
