// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "json_splice.hpp"

namespace shigusa {

// A property of a node that is animated in a file, and its rest value.
struct GltfKeyed {
  int node = 0;                // index in the file
  std::string path;            // "translation", "rotation", "scale" or "weights"
  std::vector<double> values;  // 3, 4, 3 or as many as the node's mesh has targets
};

// Animated properties of a glTF file, each once. Left out are missing nodes, nodes with a matrix,
// and meshes with more than 1024 morph targets.
[[nodiscard]] std::vector<GltfKeyed> keyed_properties(const JsonSplice& json);

}  // namespace shigusa
