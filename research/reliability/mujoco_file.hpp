// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "outside.hpp"

namespace shigusa::bench {

// An MJCF file loaded by MuJoCo itself.
class MujocoFile {
 public:
  // Null if MuJoCo is not available, or cannot load the file, since its meshes are missing.
  [[nodiscard]] static std::shared_ptr<const MujocoFile> read(const std::filesystem::path& path);
  virtual ~MujocoFile() = default;

  // Placements of the bodies that the file has, from a table's angles and root.
  [[nodiscard]] virtual OutsideMotion motion(const std::string& root, const Table& table,
                                             const std::vector<std::string>& bodies) const = 0;
};

}  // namespace shigusa::bench
