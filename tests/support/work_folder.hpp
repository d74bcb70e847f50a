// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <string_view>

#include "core/check.hpp"
#include "files/file.hpp"
#include "files/path.hpp"

namespace shigusa::testing_support {

// A new temporary folder, removed with its contents.
class WorkFolder {
 public:
  WorkFolder() {
    std::random_device random;
    do {
      path_ = std::filesystem::temp_directory_path() / ("shigusa-" + std::to_string(random()));
    } while (!std::filesystem::create_directory(path_));
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / to_path(name);
  }

  // Makes a file; the full path as the command line takes it.
  std::string put(const std::string& name, std::string_view bytes) const {
    std::filesystem::create_directories((path_ / to_path(name)).parent_path());
    const auto written = write_file(path_ / name, bytes);
    SHG_CHECK(written.has_value(), "writing " + name);
    return (path_ / to_path(name)).string();
  }

  [[nodiscard]] std::string get(const std::string& name) const {
    return bytes_of(path_ / to_path(name));
  }

  // Every file below, with its bytes; folders as "name/". Files over 1 MB count by their size, and
  // entries that are no files by their names.
  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
      const std::string name = std::filesystem::relative(entry.path(), path_).string();
      if (entry.is_directory()) {
        all[name + "/"] = "";
      } else if (!entry.is_regular_file()) {
        all[name] = "";
      } else {
        const std::uintmax_t size = entry.file_size();
        all[name] = size > kMuch ? std::to_string(size) : bytes_of(entry.path());
      }
    }
    return all;
  }

 private:
  static constexpr std::uintmax_t kMuch = 1'000'000;

  static std::string bytes_of(const std::filesystem::path& path) {
    return read_text_file(path, std::size_t{256} << 20).value();
  }

  std::filesystem::path path_;
};

}  // namespace shigusa::testing_support
