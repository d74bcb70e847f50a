// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <vector>

namespace shigusa {

struct BodyDefinition;

// A body as the kernel reads it, frame after frame: what BodyDefinition says, in the type that the
// kernel computes with, and without what can be known to be 0.
template <class T>
struct BodyConstants {
  struct Dof {
    int parent = -1;
    Axis axis = Axis::x;
    bool starts_joint = true;  // false: its centre is that of the dof before
    bool negative = false;     // a positive angle turns about the axis reversed

    Vec3<T> offset{};  // m
  };

  // One joint and the rigid piece that it moves. The freedoms of a joint lie at one centre, one
  // moves the next, and only the last one's link has mass or carries anything else.
  struct Joint {
    int first = 0;           // its freedoms are first … link
    int link = 0;            // the piece that it moves
    int parent = -1;         // joint that moves the piece which carries this one; -1: the base
    bool hangs = false;      // its centre has a y only, seen from the piece that carries it
    bool massive = false;    // the piece has mass
    bool upright = false;    // com has a y only, as has every joint that the piece carries
    bool principal = false;  // inertia has a diagonal only
    bool slants = false;     // its one freedom turns about an axis of `turns`
    T mass{};                // kg
    Vec3<T> com{};           // m, in the link frame
    Mat3<T> inertia{};       // kg·m², about the com, link axes
    Vec3<T> gyroscopic{};    // kg·m², of principal moments: z - y, x - z, y - x
  };

  Mat3<T> base_rotation{};  // R_WB of the standing foot
  Vec3<T> base_origin{};    // m, world
  T base_mass{};            // kg
  Vec3<T> base_com{};       // m, in the base's frame
  T total_mass{};           // kg
  std::vector<Dof> dofs;
  std::vector<Joint> joints;
  std::vector<Mat3<T>> turns;  // (joints) R_LA, see Dof::turn; the identity where none slants

  explicit BodyConstants(const BodyDefinition& body);
};

}  // namespace shigusa
