// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <shigusa/files.hpp>
#include <system_error>

#include "files/file.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

// Absolute path in an environment variable; relative ones are ignored (XDG Base Directory
// Specification).
std::optional<fs::path> absolute_from(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

}  // namespace

std::optional<fs::path> cache_folder() {
  if (const auto own = absolute_from("SHIGUSA_CACHE")) return own;
  if (const auto cache = absolute_from("XDG_CACHE_HOME")) return *cache / "shigusa";
  if (const auto home = absolute_from("HOME")) return *home / ".cache" / "shigusa";
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
