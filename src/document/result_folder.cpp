// SPDX-License-Identifier: MIT
#include "result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <thread>

#include "export_file.hpp"
#include "files/path.hpp"
#include "files/sha256.hpp"

namespace shigusa {
namespace {

using FileType = std::filesystem::file_type;

}  // namespace

Result<void> lock_folder(const Descriptor& folder, LockKind kind, const std::filesystem::path& path,
                         std::chrono::milliseconds longest) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kPause = std::chrono::milliseconds(10);
  for (const auto begin = Clock::now(); !try_lock(folder, kind);) {
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
  if (const int reason = staging_.open(folder)) return refused(folder, "open", reason);
  if (const int reason = staging_.make()) return refused(folder, "write to this folder", reason);
  return {};
}

Result<std::string> ResultFolder::add(const std::string& name, std::string_view bytes) {
  if (const int reason = staging_.add(name, bytes, true)) {
    return refused(staging_.path() / name, "write", reason);
  }
  files_.push_back(name);
  return sha256(bytes);
}

Result<void> ResultFolder::publish(std::string_view summary) {
  SHG_TRY(add(kSummaryName, summary));
  SHG_TRY(lock_folder(staging_.folder(), LockKind::alone, staging_.path()));
  for (const std::string& name : files_) {
    SHG_TRY(check_place(name));
  }
  return swap();
}

// Checks that a name may be written. A link is replaced and its target kept; anything but a file is
// refused.
Result<void> ResultFolder::check_place(const std::string& name) const {
  const FileType type = type_in(staging_.folder(), name);
  if (type == FileType::not_found || type == FileType::symlink) return {};
  if (type != FileType::regular) {
    const char* what = type == FileType::directory ? "a folder"
                       : type == FileType::fifo    ? "a pipe"
                                                   : "a device";
    return fail(ErrorCode::io,
                fmt::format("{} stands in the place of a result's file: remove it, or give another "
                            "folder",
                            what),
                (staging_.path() / name).string());
  }
  // a rename alone would also replace files that the user has no right to change
  const int reason = check_writable(staging_.folder(), name);
  return reason == 0 ? Result<void>{} : refused(staging_.path() / name, "write", reason);
}

Result<void> ResultFolder::swap() {
  const int removed = remove_in(staging_.folder(), kSummaryName);
  if (removed != 0 && removed != ENOENT)
    return refused(staging_.path() / kSummaryName, "remove", removed);
  SHG_TRY(settle_names());
  // the summary was added last
  for (const std::string& name : files_) {
    if (name == kSummaryName) {
      remove_older();
      SHG_TRY(settle_names());
    }
    if (const int reason = staging_.move_out(name, name)) {
      return refused(staging_.path() / name, "write", reason);
    }
  }
  return settle_names();
}

Result<void> ResultFolder::settle_names() const {
  const int reason = settle(staging_.folder());
  return reason == 0 ? Result<void>{} : refused(staging_.path(), "write to this folder", reason);
}

void ResultFolder::remove_older() const {
  const Descriptor& folder = staging_.folder();
  for (const std::string& name : names_in(folder)) {
    const FileType type = type_in(folder, name);
    if (!is_result_file(name) || (type != FileType::regular && type != FileType::symlink)) continue;
    if (std::find(files_.begin(), files_.end(), name) == files_.end()) remove_in(folder, name);
  }
}

Result<void> check_described(const std::filesystem::path& path, const Descriptor& folder,
                             const CandidateFiles& files) {
  for (const auto& [format, file] : files) {
    if (file.sha256.empty()) continue;
    if (type_in(folder, file.name) == FileType::not_found) continue;
    const Descriptor opened = open_entry(folder, file.name);
    if (type_of(opened) == FileType::regular && sha256_of(opened) == file.sha256) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("is not the file that {} describes: it was changed, or is another "
                            "result's. Delete it to go on without it, or make the result anew",
                            kSummaryName),
                (path / to_path(file.name)).string());
  }
  return {};
}

}  // namespace shigusa
