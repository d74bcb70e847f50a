// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

namespace shigusa {

// A vertex of a character's mesh, in one posture.
struct SkinVertex {
  Vec3d position{};  // the world of that posture, in the skeleton's own units and axes
  int node = -1;     // node of the skeleton with the greatest weight
  // whether its mesh is rigidly attached to the node, as a robot's part, a hat or a sword is
  bool rigid = false;
};

// A character's mesh from a reader of any file format.
struct Skin {
  std::vector<SkinVertex> vertices;  // empty if the file has no readable mesh
  // indices of vertices, where they are asked for in place of points on the faces
  std::vector<std::array<std::size_t, 3>> triangles{};
  std::vector<Message> doubts;  // parts that were not read, and why
};

}  // namespace shigusa
