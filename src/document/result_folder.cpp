// SPDX-License-Identifier: MIT
#include "result_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <thread>

#include "export_file.hpp"
#include "files/sha256.hpp"

namespace shigusa {
namespace {

// Sees to it that the names in a folder are on the disk; some file systems cannot tell.
int settle(const Descriptor& folder) {
  return fsync(folder.number()) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

bool exists(const Descriptor& folder, const std::string& name, struct stat& status) {
  return fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
}

}  // namespace

Result<void> lock_folder(const Descriptor& folder, FolderUse use, const std::filesystem::path& path,
                         std::chrono::milliseconds longest) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kPause = std::chrono::milliseconds(10);
  const int kind = (use == FolderUse::write ? LOCK_EX : LOCK_SH) | LOCK_NB;
  for (const auto begin = Clock::now(); flock(folder.number(), kind) != 0;) {
    if (errno != EWOULDBLOCK && errno != EINTR) return {};
    if (Clock::now() - begin > longest) {
      return fail(ErrorCode::io,
                  "another program writes a result there, or hangs while it does: wait for it, or "
                  "end it",
                  path.string());
    }
    std::this_thread::sleep_for(kPause);
  }
  return {};
}

Result<void> ResultFolder::open(const std::filesystem::path& folder) {
  path_ = folder;
  folder_ = open_at(AT_FDCWD, folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (!folder_) return refused(folder, "open", errno);
  staging_.emplace(folder_);
  if (const int reason = staging_->make()) return refused(folder, "write to this folder", reason);
  return {};
}

Result<std::string> ResultFolder::add(const std::string& name, std::string_view bytes) {
  if (const int reason = staging_->add(name, bytes, true)) {
    return refused(path_ / name, "write", reason);
  }
  files_.push_back(name);
  return sha256(bytes);
}

Result<void> ResultFolder::publish(std::string_view summary) {
  SHG_TRY(add(kSummaryName, summary));
  SHG_TRY(lock_folder(folder_, FolderUse::write, path_));
  for (const std::string& name : files_) {
    SHG_TRY(check_place(name));
  }
  return swap();
}

// A link is replaced, and what it leads to stays; other things than files are somebody's.
Result<void> ResultFolder::check_place(const std::string& name) const {
  struct stat status {};
  if (!exists(folder_, name, status) || S_ISLNK(status.st_mode)) return {};
  if (!S_ISREG(status.st_mode)) {
    const char* what = S_ISDIR(status.st_mode)    ? "a folder"
                       : S_ISFIFO(status.st_mode) ? "a pipe"
                                                  : "a device";
    return fail(ErrorCode::io,
                fmt::format("{} stands in the place of a result's file: remove it, or give another "
                            "folder",
                            what),
                (path_ / name).string());
  }
  // renaming alone would also replace files that the user may not change
  if (faccessat(folder_.number(), name.c_str(), W_OK, 0) == 0) return {};
  return refused(path_ / name, "write", errno);
}

Result<void> ResultFolder::swap() {
  if (unlinkat(folder_.number(), kSummaryName, 0) != 0 && errno != ENOENT) {
    return refused(path_ / kSummaryName, "remove", errno);
  }
  if (const int reason = settle(folder_)) return refused(path_, "write to this folder", reason);
  // the summary was added last
  for (const std::string& name : files_) {
    if (name == kSummaryName) {
      remove_older();
      if (const int reason = settle(folder_)) return refused(path_, "write to this folder", reason);
    }
    if (const int reason = staging_->move_out(name, name)) {
      return refused(path_ / name, "write", reason);
    }
  }
  const int reason = settle(folder_);
  return reason == 0 ? Result<void>{} : refused(path_, "write to this folder", reason);
}

void ResultFolder::remove_older() const {
  for (const std::string& name : names_in(folder_)) {
    struct stat status {};
    if (!is_result_file(name) || !exists(folder_, name, status)) continue;
    if (!S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) continue;
    if (std::find(files_.begin(), files_.end(), name) != files_.end()) continue;
    unlinkat(folder_.number(), name.c_str(), 0);
  }
}

Result<void> check_described(const std::filesystem::path& path, const Descriptor& folder,
                             const CandidateFiles& files) {
  for (const auto& [format, file] : files) {
    if (file.sha256.empty()) continue;
    struct stat status {};
    if (!exists(folder, file.name, status)) continue;
    // no link is followed, and nothing is waited for
    const Descriptor opened =
        open_at(folder.number(), file.name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    const bool same = opened && fstat(opened.number(), &status) == 0 && S_ISREG(status.st_mode) &&
                      sha256_of(opened) == file.sha256;
    if (same) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("is not the file that {} describes: it was changed, or is another "
                            "result's. Delete it to go on without it, or make the result anew",
                            kSummaryName),
                (path / file.name).string());
  }
  return {};
}

}  // namespace shigusa
