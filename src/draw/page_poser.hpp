// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <shigusa/generate.hpp>
#include <vector>

#include "strip_figure_body.hpp"

namespace shigusa {

using PagePoint = std::array<std::int32_t, 3>;  // mm, world

// Whole millimetres, at most 1 km.
[[nodiscard]] std::int32_t to_millimetres(double metres);
[[nodiscard]] PagePoint to_millimetres(const Vec3d& p);

// Figure of a body in all poses of a motion. Its points are the balls of its parts, followed by the
// points that go to goals, or by those of things.
struct PosedFigure {
  double size = 0.0;                           // m
  std::vector<strip::Part> parts;              // in the first pose
  std::vector<std::vector<PagePoint>> points;  // (points × poses)
};

// The figure of a candidate, one of a result's motions.
[[nodiscard]] PosedFigure posed_figure(const Task& task, const Candidate& candidate,
                                       const GenerateResult& generation);

// Points of a thing in its own axes (see page_figures).
[[nodiscard]] std::vector<Vec3d> points_of(const Thing& thing);

}  // namespace shigusa
