// SPDX-License-Identifier: MIT
#include "page.hpp"

#include <fmt/format.h>

#include <array>
#include <system_error>
#include <utility>

#include "files/file.hpp"

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;

const char* type_of(const fs::path& file) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 10> kTypes{{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript"},
      {".css", "text/css"},
      {".wasm", "application/wasm"},
      {".json", "application/json"},
      {".svg", "image/svg+xml"},
      {".tsv", "text/tab-separated-values"},
      {".png", "image/png"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
  }};
  const std::string ending = file.extension().string();
  for (const auto& [known, type] : kTypes) {
    if (ending == known) return type;
  }
  return "application/octet-stream";
}

}  // namespace

Result<Page> read_page(const fs::path& folder) {
  Page page;
  std::size_t bytes = 0;
  std::size_t entries = 0;
  const auto too_much = [&folder] {
    return fail(ErrorCode::invalid_argument,
                fmt::format("holds more than the {} files or {} MB that a built page may have; is "
                            "it the page's folder?",
                            kPageMostEntries, kPageMostBytes >> 20),
                folder.string());
  };
  std::error_code wrong;
  // links to folders are not entered by it
  for (fs::recursive_directory_iterator at(folder, wrong), end; !wrong && at != end;
       at.increment(wrong)) {
    if (++entries > kPageMostEntries) return too_much();
    std::error_code gone;
    if (at->symlink_status(gone).type() != fs::file_type::regular) continue;
    if (at->file_size(gone) > kPageMostBytes - bytes) return too_much();
    SHG_TRY_ASSIGN(std::string read, read_text_file(at->path(), kPageMostBytes - bytes));
    bytes += read.size();
    const std::string path = "/" + at->path().lexically_relative(folder).generic_string();
    page[path] = {type_of(at->path()), std::move(read)};
  }
  if (wrong) return fail(ErrorCode::io, "cannot be read: " + wrong.message(), folder.string());
  if (!page.contains("/index.html")) {
    return fail(ErrorCode::not_found, "holds no index.html (links are not followed)",
                folder.string());
  }
  return page;
}

}  // namespace shigusa::app
