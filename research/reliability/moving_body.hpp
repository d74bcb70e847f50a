// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

// Torques and forces of a motion, by the Newton-Euler equations of rigid pieces with given
// placements in each frame: finite differences between frames, no recursion along a tree.
namespace shigusa::bench {

// A rigid piece.
struct MovingPiece {
  double mass = 0.0;                               // kg
  Mat3d inertia{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // kg·m², about its centre, in its own axes
  std::vector<Vec3d> centre;                       // (frames) m, world
  std::vector<Mat3d> turn;                         // (frames) from its axes to the world's
};

// A hinge, and all pieces supported by it alone.
struct MovingHinge {
  std::string name;
  double positive = 0.0;    // N·m, strength towards larger angles
  double negative = 0.0;    // N·m, towards smaller ones
  std::vector<Vec3d> at;    // (frames) m, world
  std::vector<Vec3d> axis;  // (frames) unit vectors, world
  std::vector<std::size_t> carries;
};

// An external force on a piece.
struct MovingForce {
  std::size_t piece = 0;
  std::vector<Vec3d> at;     // (frames) m, world
  std::vector<Vec3d> force;  // (frames) N, world
};

struct MovingBody {
  double frame_time = 0.0;  // s
  int frames = 0;
  std::vector<MovingPiece> pieces;
  std::vector<MovingHinge> hinges;
  std::vector<MovingForce> forces;
};

// Force (N) and moment about the world's origin (N·m) required by pieces in a frame, weight
// included.
struct Wrench {
  Vec3d force{};
  Vec3d moment{};
};
// (frames × pieces) of a motion at rest before and after.
[[nodiscard]] std::vector<Wrench> piece_wrenches(const MovingBody& body);

// (frames) N·m, required torque of a hinge.
[[nodiscard]] std::vector<double> hinge_torque(const MovingBody& body,
                                               const std::vector<Wrench>& wrenches,
                                               const MovingHinge& hinge);

// (frames) total force of the floor.
[[nodiscard]] std::vector<Wrench> floor_wrenches(const MovingBody& body,
                                                 const std::vector<Wrench>& wrenches);

}  // namespace shigusa::bench
