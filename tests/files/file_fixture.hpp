// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "support/work_folder.hpp"

namespace shigusa::testing_support {

constexpr std::size_t kPlenty = 1 << 20;

// A folder of its own for each test.
class File : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_ / name; }

  // Makes a file without the functions that are tested.
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(at(name)) << text;
  }

  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_.path()),
                      std::filesystem::directory_iterator()));
  }

  WorkFolder folder_;
};

}  // namespace shigusa::testing_support
