// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/core/field.hpp>
#include <shigusa/math/quat.hpp>
#include <string>

namespace shigusa {

// A goal's and an obstacle's coordinates may not exceed this (m): nobody reaches so far, and
// numbers stay harmless.
inline constexpr double kGoalRange = 100.0;

// Something in the world that a body should not pass through: a box with round edges. One without
// size is a sphere, one with size along a single axis a capsule.
struct Obstacle {
  std::string name;     // "table"
  Vec3d position{};     // m, world, of its middle
  Quatd rotation{};     // R_WO, a unit quaternion
  Vec3d size{};         // m, along its own axes, ≥ 0
  double radius = 0.0;  // m, ≥ 0, beyond the size on all sides
};

template <>
inline constexpr FieldTable kFields<Obstacle>{
    "obstacle",
    "A box with round edges: without size_m a sphere, with size along one axis a capsule.",
    std::tuple{
        Field{"name", &Obstacle::name, "For messages.", {.written = always}},
        Field{"position_m",
              &Obstacle::position,
              "Its middle.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"size_m",
              &Obstacle::size,
              "Along its own axes.",
              {.high = kGoalRange, .written = always}},
        Field{"radius_m",
              &Obstacle::radius,
              "Of its round edges, beyond the size on all sides.",
              {.high = kGoalRange, .written = always}},
        Field{"rotation_xyzw",
              &Obstacle::rotation,
              "A unit quaternion.",
              {.mirroring = Mirroring::other_side, .written = always}},
    }};

}  // namespace shigusa
