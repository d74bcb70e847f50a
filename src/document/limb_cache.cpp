// SPDX-License-Identifier: MIT
#include <shigusa/files.hpp>
#include <system_error>

#include "files/file.hpp"
#include "files/path.hpp"

namespace shigusa {

namespace fs = std::filesystem;

std::optional<fs::path> cache_folder() {
  if (const auto own = path_in_environment("SHIGUSA_CACHE")) return own;
  if (const auto cache = path_in_environment("XDG_CACHE_HOME")) return *cache / "shigusa";
  if (const auto windows = path_in_environment("LOCALAPPDATA")) return *windows / "shigusa";
  if (const auto home = path_in_environment("HOME")) return *home / ".cache" / "shigusa";
  return std::nullopt;
}

LimbStore limb_store(const fs::path& folder) {
  LimbStore store;
  store.load = [folder](const std::string& name) -> std::optional<std::string> {
    Result<std::string> bytes = read_text_file(folder / name, kMaxLimbFile);
    if (!bytes) return std::nullopt;
    return std::move(*bytes);
  };
  store.save = [folder](const std::string& name, std::string_view bytes) {
    std::error_code refused;
    fs::create_directories(folder, refused);
    if (refused) return;
    // a failure to store is harmless: the library is computed again
    (void)write_file(folder / name, bytes);
  };
  return store;
}

LimbStore limb_store() {
  const auto folder = cache_folder();
  return folder ? limb_store(*folder) : LimbStore{};
}

}  // namespace shigusa
