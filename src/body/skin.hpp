// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

namespace shigusa {

// A point of the mesh that a character's skeleton moves, as it stands in one posture.
struct SkinVertex {
  Vec3d position{};  // the world of that posture, in the skeleton's own units and axes
  int node = -1;     // of the skeleton: the one that moves the vertex most
  // Its mesh is not skinned but hangs on the node as one piece: a robot's part, a hat, a sword.
  bool rigid = false;
};

// A character's mesh, as a reader of any file format gives it.
struct Skin {
  std::vector<SkinVertex> vertices;  // none where the file has no mesh, or none that is read
  std::vector<Message> doubts;       // parts that were not read, and why
};

}  // namespace shigusa
