// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <shigusa/error.hpp>
#include <string>

namespace shigusa::app {

struct PageFile {
  std::string type;  // as HTTP names it, "text/html"
  std::string bytes;
};

// By requested path, "/assets/main.js".
using Page = std::map<std::string, PageFile, std::less<>>;

inline constexpr std::size_t kPageMostBytes = std::size_t{64} << 20;
inline constexpr std::size_t kPageMostEntries = 1000;

// Reads all files of a folder and its subfolders once; later changes of the folder are not served.
// Links are left out, as they may lead elsewhere. Fails without an index.html, and on more files or
// bytes than a built page has.
[[nodiscard]] Result<Page> read_page(const std::filesystem::path& folder);

}  // namespace shigusa::app
