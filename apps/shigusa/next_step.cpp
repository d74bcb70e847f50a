// SPDX-License-Identifier: MIT
#include "next_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <vector>

#include "files/path.hpp"

#ifdef SHIGUSA_HAS_DATASETS
#include <shigusa/dataset.hpp>
#endif

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;

// Largest number of files in a folder that is searched for names.
constexpr std::size_t kNamesMax = 1000;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    names.push_back(at->path().filename().string());
    if (names.size() > kNamesMax) return {};
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Hint for a missing file: those in its folder with the same ending, "; this folder has hero.vrm".
std::string files_alike(const fs::path& path, const fs::path& folder,
                        const std::vector<std::string>& names) {
  constexpr std::size_t kToldMost = 5;
  const std::string where = folder == "." ? "this folder" : folder.string();
  const std::string ending = file_ending(path.string());
  if (ending.empty() || names.empty()) return {};
  std::vector<std::string> alike;
  for (const std::string& name : names) {
    if (file_ending(name) == ending) alike.push_back(name);
  }
  if (alike.size() > kToldMost) return {};
  if (alike.empty()) return fmt::format("; {} has no {} file", where, ending);
  return fmt::format("; {} has {}", where, fmt::join(alike, ", "));
}

// Hint for a missing path: the nearest existing one.
std::string nearest_path(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    return fmt::format("; there is no folder {}", folder.string());
  }
  const std::vector<std::string> names = names_in(folder);
  const std::string_view nearest = nearest_name(path.filename().string(), names);
  if (nearest.empty()) return files_alike(path, folder, names);
  return fmt::format("; did you mean '{}'?", (path.parent_path() / to_path(nearest)).string());
}

}  // namespace

std::string next_step(const Error& error) {
  if (error.message.key == "version_is") {
    return "; another version of shigusa wrote it: make it again by this one";
  }
  std::error_code ignored;
  const fs::path path = to_path(error.place);
  const std::string& text = error.message.text;
  const bool is_missing =
      text.ends_with("No such file or directory") || text.ends_with("Not a directory");
  if (!is_missing || path.empty() || fs::exists(path, ignored)) return {};
  if (fs::is_directory(path.parent_path(), ignored)) {
    if (path.filename() == kSummaryName) {
      return "; a result is a folder that reach, edit or mirror wrote";
    }
#ifdef SHIGUSA_HAS_DATASETS
    if (path.filename() == kPlanName) {
      return "; a data set is a folder that `shigusa dataset PLAN --out FOLDER` made";
    }
#endif
  }
  return nearest_path(path);
}

std::string centimetre_hint(double metres, double low, double high) {
  const double asked = metres / 100.0;
  if (!(asked >= low && asked <= high)) return {};
  return fmt::format("; {:g} cm are {:g}", metres, asked);
}

}  // namespace shigusa::app
