// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "human/segment_mass.hpp"
#include "mjcf_values.hpp"

namespace shigusa {

// A shape of a body, in the frame of its element's parent.
struct MjcfGeom {
  bool solid = false;     // a shape that is read: no mesh, plane or height field
  bool mesh = false;      // a mesh with mass, whose shape is unknown
  bool collides = false;  // with anything
  Robot::Shape shape;  // in the frame of its element; a capsule is a cylinder, an ellipsoid a box
  LinkMass mass;       // in the frame of its element
};

[[nodiscard]] MjcfGeom read_geom(MjcfFiles& files, MjcfValues& values, const MjcfPart& part);

// Mass properties of an <inertial>, in the frame of its parent.
[[nodiscard]] LinkMass read_inertial(MjcfFiles& files, MjcfValues& values, const MjcfPart& part);

}  // namespace shigusa
