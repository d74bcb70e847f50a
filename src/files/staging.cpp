// SPDX-License-Identifier: MIT
#include "staging.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <random>

#include "path.hpp"

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
  const int reason = lock_now(entry, LockKind::alone);
  return reason == 0 || (reason != EWOULDBLOCK && older_than(entry, std::chrono::hours(24)));
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
    remove_folder_in(folder, name);
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
  if (const int reason = make_folder_in(folder_, name)) return reason;
  Descriptor made = open_entry(folder_, name);
  if (!made) {
    const int reason = errno;
    remove_folder_in(folder_, name);
    // an unlocked one may have been removed as a leftover
    return reason == ENOENT ? EEXIST : reason;
  }
  if (!try_lock(made, LockKind::alone) || !is_named(made, folder_, name)) return EEXIST;
  self_ = std::move(made);
  name_ = name;
  return 0;
}

std::filesystem::path Staging::path_of(const std::string& name) const {
  return path_ / name_ / to_path(name);
}

Descriptor Staging::create(const std::string& name) {
  Descriptor file = create_in(self_, name);
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
  if (const int reason = move_in(self_, name, folder_, to)) return reason;
  std::erase(files_, name);
  return 0;
}

Staging::~Staging() {
  if (!self_) return;
  try {
    for (const std::string& name : files_) remove_in(self_, name);
    remove_folder_in(folder_, name_);
  } catch (const std::bad_alloc&) {
    // a later program removes the leftovers
  }
}

}  // namespace shigusa
