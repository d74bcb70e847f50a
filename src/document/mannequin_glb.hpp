// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "draw/mannequin.hpp"

namespace shigusa {

// The mannequin at rest as a GLB file: `named` has the names of its nodes, `skin` the vertex
// positions of its mesh.
[[nodiscard]] std::string mannequin_glb(const std::string& name, const Skeleton& named,
                                        const Mannequin& mannequin, const std::vector<Vec3d>& skin);

}  // namespace shigusa
