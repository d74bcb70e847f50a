// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

namespace shigusa {

// A bone that moves the mannequin's skin.
struct SkinBone {
  enum class Kind {
    node,    // a node of the body
    half,    // follows half of a joint's rotation, without its twist
    swing,   // follows all of it without its twist
    roll,    // follows all of it with half its twist
    finger,  // a bone of a finger
  };
  std::string name;
  Kind kind = Kind::node;
  std::string of;                 // joint that is followed; parent of a finger's bone
  Vec3d place{};                  // m, in mesh space
  double angle = 0.0;             // rad, about the axis ahead, from a hanging limb in mesh space
  Vec3d axis{};                   // bending axis of a finger, in the axes of a hanging arm
  std::array<double, 3> bends{};  // rad: open, relaxed, in a grip
};

// The page's mannequin as made by studio/figure/make.mjs: the skin of a man of average mass, and
// the vertex shifts that give other builds.
struct MannequinMesh {
  double stature = 0.0;                    // m
  std::map<std::string, double> measures;  // m, bone lengths
  std::map<std::string, double> volumes;   // m³, of the man and of the shapes that the shifts give
  std::vector<SkinBone> bones;
  std::vector<Vec3d> positions;                      // m
  std::map<std::string, std::vector<Vec3d>> shifts;  // m, per position
  std::vector<std::array<std::uint8_t, 4>> joints;   // per position: indices of bones
  std::vector<std::array<std::uint8_t, 4>> weights;  // per position: weights of the bones, of 255
  std::vector<std::uint16_t> corners;                // three per triangle

  // Positions of a person's skin; `mass`: relative to that of an average person of the stature.
  [[nodiscard]] std::vector<Vec3d> skin(bool female, double mass) const;
};

// The embedded mesh, unpacked once.
[[nodiscard]] const MannequinMesh& mannequin_mesh();

// Unit normals of the positions, from the adjacent triangles.
[[nodiscard]] std::vector<Vec3d> vertex_normals(const std::vector<Vec3d>& positions,
                                                const std::vector<std::uint16_t>& corners);

}  // namespace shigusa
