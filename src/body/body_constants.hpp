// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <vector>

namespace shigusa {

struct BodyDefinition;

// A body in the kernel's form, read in every frame: the contents of BodyDefinition in the kernel's
// scalar type, with flags for values known to be 0.
template <class T>
struct BodyConstants {
  struct Dof {
    int parent = -1;
    Axis axis = Axis::x;
    bool starts_joint = true;  // false: its centre is that of the dof before
    bool negative = false;     // positive angles turn about the reversed axis

    Vec3<T> offset{};  // m
  };

  // One joint and the rigid piece that it moves. The degrees of freedom of a joint share one
  // centre, each moves the next, and only the last one's link has mass or children.
  struct Joint {
    int first = 0;           // its degrees of freedom are first … link
    int link = 0;            // link of the piece that it moves
    int parent = -1;         // joint of the parent piece; -1: the base
    bool hangs = false;      // relative to the parent piece, its centre has a y only
    bool massive = false;    // the piece has mass
    bool upright = false;    // com has a y only, and so do the centres of all child joints
    bool principal = false;  // inertia is diagonal
    bool slants = false;     // its only degree of freedom has an axis in `turns`
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
  std::vector<Mat3<T>> turns;  // (joints) R_LA, see Dof::turn; the identity for aligned axes

  explicit BodyConstants(const BodyDefinition& body);
};

}  // namespace shigusa
