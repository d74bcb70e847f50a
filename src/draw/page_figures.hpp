// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <shigusa/request.hpp>
#include <string>

namespace shigusa {

// The figures of a result as the page's script reads them: a JSON object with
//
//   size     mm, the body's stature or a length in its place
//   side     1 where the viewer stands on the figure's right, -1 on its left
//   seconds  of the motions
//   parts    [tone, setback, foot, [[point, radius], …]]: the convex hulls that the figure is made
//            of (mm); tone is 0 left, 1 right, 2 middle, 3 of a goal's limb, 4 a plain bone
//   goals    [x, y, z] mm, one for each, and paths, the point that goes to each
//   soles    of each planted foot the corners of what stands, [x, y, z] mm
//   boxes    of each obstacle and the seat its eight corners and its radius, mm
//   motions  of each candidate its poses and its code
//
// The code holds the places of all points: for each point, for each of x, y and z its values in mm
// over the poses, as the first one, then how much it grows from pose to pose, told by how much that
// changes. Each number is a base64 VLQ as source maps have them, the sign in the lowest bit: a
// digit has five bits and tells whether more follow, the lowest first.
[[nodiscard]] std::string page_figures(const Task& task, const GenerateResult& generation);

}  // namespace shigusa
