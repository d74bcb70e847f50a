// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <span>
#include <vector>

#include "formats/gltf_write.hpp"
#include "measure/measure_person.hpp"

namespace shigusa {

// Mesh of a thing about its middle, along its own axes; `unit`: m per unit of the mesh.
[[nodiscard]] GltfMesh mesh_of(const Thing& thing, double unit = 1.0);

// Things with their ways in the world of an exported file, where its motions are: shigusa's world
// divided by the unit; of a mirrored file, its own axes. `kept`: (frames) horizontal ways that were
// taken off the hips, in that world; empty: none were.
[[nodiscard]] std::vector<GltfThing> things_in_file(std::span<const ThingMotion> ways,
                                                    const Placement& file,
                                                    std::span<const Vec3d> kept);

// The actions of a candidate as markers of its animation.
[[nodiscard]] std::vector<GltfMarker> markers_of(const Candidate& candidate);

}  // namespace shigusa
