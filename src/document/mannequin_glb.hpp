// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "draw/mannequin.hpp"

namespace shigusa {

// The mannequin at rest as a GLB file: `named` has its nodes' names, `skin` the mesh's positions
// where it is made.
[[nodiscard]] std::string mannequin_glb(const std::string& name, const Skeleton& named,
                                        const Mannequin& mannequin, const std::vector<Vec3d>& skin);

}  // namespace shigusa
