// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "json_splice.hpp"

namespace shigusa {

// A property of a node that an animation of a file has keys of, and its value at rest.
struct GltfKeyed {
  int node = 0;                // index in the file
  std::string path;            // "translation", "rotation", "scale" or "weights"
  std::vector<double> values;  // 3, 4, 3 or as many as the node's mesh has targets
};

// The properties that the animations of a glTF file have keys of, each once. Left out are nodes
// that the file has not, those with a matrix, and meshes with more than 1024 targets.
[[nodiscard]] std::vector<GltfKeyed> keyed_properties(const JsonSplice& json);

}  // namespace shigusa
