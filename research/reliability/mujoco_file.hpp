// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "outside.hpp"

namespace shigusa::bench {

// An MJCF file as MuJoCo itself reads it.
class MujocoFile {
 public:
  // Null where MuJoCo is not there, or does not read the file, as its meshes are missing.
  [[nodiscard]] static std::shared_ptr<const MujocoFile> read(const std::filesystem::path& path);
  virtual ~MujocoFile() = default;

  // Where those of the bodies are that the file has, by a table's angles and its root's place.
  [[nodiscard]] virtual OutsideMotion motion(const std::string& root, const Table& table,
                                             const std::vector<std::string>& bodies) const = 0;
};

}  // namespace shigusa::bench
