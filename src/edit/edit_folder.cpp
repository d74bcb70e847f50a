// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/edit.hpp>

#include "document/export_file.hpp"
#include "files/staging.hpp"

namespace shigusa {

namespace fs = std::filesystem;

// The inner staging folder is locked while this object lives, which marks the outer folder as in
// use.
struct EditFolder::Held {
  Staging staging;
};

EditFolder::EditFolder(std::unique_ptr<Held> held) : held_(std::move(held)) {}
EditFolder::EditFolder(EditFolder&&) noexcept = default;
EditFolder& EditFolder::operator=(EditFolder&&) noexcept = default;

EditFolder::~EditFolder() {
  if (!held_) return;
  const fs::path path = held_->staging.path();
  held_.reset();
  // an unused folder is removed
  std::error_code not_empty;
  fs::remove(path, not_empty);
}

const fs::path& EditFolder::path() const { return held_->staging.path(); }

namespace {

// Whether a folder contains only the leftovers of a killed program: files of candidates without a
// summary, and staging folders.
bool is_left(const Descriptor& folder) {
  const std::vector<std::string> names = names_in(folder);
  return std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return is_staging_name(name) || (is_result_file(name) && name != kSummaryName);
  });
}

// Whether another program has a staging folder in the same folder.
bool is_shared(const Descriptor& folder) {
  const std::vector<std::string> names = names_in(folder);
  return std::count_if(names.begin(), names.end(), is_staging_name) > 1;
}

}  // namespace

Result<EditFolder> EditFolder::make(const fs::path& within, std::string_view name) {
  for (int k = 1;; ++k) {
    auto held = std::make_unique<Held>();
    const fs::path path = within / fmt::format("{}-{}", name, k);
    std::error_code error;
    const bool made = fs::create_directory(path, error);
    if (error && error != std::errc::file_exists) {
      return refused(path, "make this folder", error.default_error_condition().value());
    }
    Staging& staging = held->staging;
    const bool opened = staging.open(path) == 0;
    if (!made && (!opened || !is_left(staging.folder()))) continue;
    const int reason = staging.make();
    if (reason != 0 && made) return refused(path, "write to this folder", reason);
    // two programs that find it at once see each other, and both continue
    if (reason == 0 && !is_shared(staging.folder())) return EditFolder(std::move(held));
  }
}

}  // namespace shigusa
