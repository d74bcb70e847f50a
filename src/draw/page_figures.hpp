// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <shigusa/request.hpp>
#include <string>

namespace shigusa {

// The figures of a result for the page's script: a JSON object with
//
//   size     mm, the body's stature or a substitute length
//   side     1 if the viewer stands on the figure's right, -1 on its left
//   seconds  duration of the motions
//   parts    [tone, setback, foot, [[point, radius], …]]: convex hulls that make up the figure
//            (mm); tone is 0 left, 1 right, 2 middle, 3 of a goal's limb, 4 a plain bone
//   goals    [x, y, z] mm per goal; and paths, the point that goes to each
//   soles    per planted foot the corners of its sole, [x, y, z] mm
//   boxes    per obstacle and seat the eight corners and the radius, mm
//   motions  per candidate its poses and its code
//
// Of a piece of work there are also
//
//   things   [radius, [point, …]] per thing, mm: eight corners of a box, the ends of a cylinder's
//            axis, the middle of a sphere
//   actions  in each of the motions [name, start, end, [goal, …]], s
//
// Its motions have the same times: a shorter one stays at its end. They have no paths.
//
// The code holds the positions of all points: per point and coordinate its values in mm over the
// poses, as the first value, then the changes of its increments. Each number is a base64 VLQ as in
// source maps, with the sign in the lowest bit: a digit has five bits and a continuation bit,
// lowest first.
[[nodiscard]] std::string page_figures(const Task& task, const GenerateResult& generation);

// Whether a result is of a piece of work.
[[nodiscard]] bool is_work(const GenerateResult& generation);

// Duration of its motions; of a piece of work the longest (s).
[[nodiscard]] double page_seconds(const GenerateResult& generation);

}  // namespace shigusa
