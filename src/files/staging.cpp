// SPDX-License-Identifier: MIT
#include "staging.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <random>

namespace shigusa {
namespace {

constexpr std::string_view kPrefix = ".shigusa-";
constexpr std::string_view kSuffix = ".tmp";
constexpr std::size_t kDigits = 16;  // of a name, hexadecimal, at most

// Not from a seed: two programs must not use the same name.
std::string new_name() {
  std::random_device random;
  return fmt::format("{}{:08x}{:08x}{}", kPrefix, random(), random(), kSuffix);
}

}  // namespace

bool is_staging_name(std::string_view name) {
  if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) return false;
  if (name.size() <= kPrefix.size() + kSuffix.size()) return false;
  name.remove_prefix(kPrefix.size());
  name.remove_suffix(kSuffix.size());
  return name.size() <= kDigits && name.find_first_not_of("0123456789abcdef") == name.npos;
}

namespace {

// Whether an open folder or file is abandoned. On file systems without locks its age decides.
bool abandoned(const Descriptor& entry) {
  constexpr std::time_t kOld = 24 * 60 * 60;  // s
  if (flock(entry.number(), LOCK_EX | LOCK_NB) == 0) return true;
  struct stat status {};
  return errno != EWOULDBLOCK && fstat(entry.number(), &status) == 0 &&
         status.st_mtime + kOld < std::time(nullptr);
}

}  // namespace

// Removes abandoned staging folders, and temporary files of earlier versions.
void remove_leftovers(const Descriptor& folder) {
  using Type = std::filesystem::file_type;
  for (const std::string& name : names_in(folder)) {
    if (!is_staging_name(name)) continue;
    const Descriptor entry = open_entry(folder, name);
    const Type type = type_of(entry);
    if ((type != Type::regular && type != Type::directory) || !abandoned(entry)) continue;
    if (type == Type::regular) {
      remove_in(folder, name);
      continue;
    }
    for (const std::string& file : names_in(entry)) remove_in(entry, file);
    unlinkat(folder.number(), name.c_str(), AT_REMOVEDIR);
  }
}

int Staging::open(const std::filesystem::path& path) {
  path_ = path;
  folder_ = open_folder(path);
  return folder_ ? 0 : errno;
}

int Staging::make() {
  remove_leftovers(folder_);
  constexpr int kTries = 100;
  int reason = EEXIST;
  for (int i = 0; i < kTries && reason == EEXIST; ++i) reason = make_locked(new_name());
  return reason;
}

// EEXIST: another name must be tried.
int Staging::make_locked(const std::string& name) {
  if (mkdirat(folder_.number(), name.c_str(), 0700) != 0) return errno;
  Descriptor made = open_at(folder_.number(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
  if (!made) {
    const int reason = errno;
    unlinkat(folder_.number(), name.c_str(), AT_REMOVEDIR);
    // an unlocked one may have been removed as a leftover
    return reason == ENOENT ? EEXIST : reason;
  }
  (void)flock(made.number(), LOCK_EX);
  struct stat ours {};
  struct stat named {};
  const bool there = fstatat(folder_.number(), name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0;
  if (fstat(made.number(), &ours) != 0) return errno;
  if (!there || ours.st_ino != named.st_ino) return EEXIST;
  self_ = std::move(made);
  name_ = name;
  return 0;
}

std::filesystem::path Staging::path_of(const std::string& name) const {
  return path_ / name_ / name;
}

Descriptor Staging::create(const std::string& name) {
  Descriptor file = open_at(self_.number(), name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW);
  if (file) files_.push_back(name);
  return file;
}

int Staging::add(const std::string& name, std::string_view bytes, bool durable) {
  Descriptor file = create(name);
  if (!file) return errno;
  if (const int reason = write_all(file, bytes)) return reason;
  if (const int reason = durable ? settle(file) : 0) return reason;
  return file.close();
}

int Staging::move_out(const std::string& name, const std::string& to) {
  struct stat old {};
  const bool there = fstatat(folder_.number(), to.c_str(), &old, AT_SYMLINK_NOFOLLOW) == 0;
  constexpr mode_t kPermissions = 0777;
  if (there && S_ISREG(old.st_mode) &&
      fchmodat(self_.number(), name.c_str(), old.st_mode & kPermissions, 0) != 0) {
    return errno;
  }
  if (renameat(self_.number(), name.c_str(), folder_.number(), to.c_str()) != 0) return errno;
  std::erase(files_, name);
  return 0;
}

Staging::~Staging() {
  if (!self_) return;
  for (const std::string& name : files_) remove_in(self_, name);
  unlinkat(folder_.number(), name_.c_str(), AT_REMOVEDIR);
}

}  // namespace shigusa
